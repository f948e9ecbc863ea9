// Effects that noise hides: single runs see them beyond chance, and they are too weak to be named.
#pragma once
#include <functional>

#include "../diagnosis.hpp"
#include "../residual/left.hpp"
#include "../trial/attempt.hpp"
#include "../trial/merit.hpp"

namespace diagnosis::runs {

// Beside a fitted model each by itself, the surest first: kByChance deviations when linearised and when fitted, and unseen windows
// do not speak against it. Where the model leaves noise alone (left) they are asked only if a number of it is not known to 5 %: what is well
// known they do not move. Shapes of the rig's own forces are not asked: accelerometers round jumps alike.
// matters: whether one is worth fitting. One that is not counts as one of the surest all the same.
std::vector<Attempt> near_chance(const Task& task, const State& beside, const Left& left,
                                 const std::function<bool(const Screened&)>& matters);

// Whether one of them is sure, and windows that the fit has not seen gain by it too, more than one in 20 does by chance: two tests that know
// nothing of each other, together as rare as what is searched for.
bool worth_a_search(const Task& task, const State& beside, const Left& left);

// They may be there: numbers of d that one of them takes out of their intervals, by a twentieth at least, may be bent.
void doubt_numbers(const Task& task, const State& beside, const Left& left, Diagnosis& d);

}  // namespace diagnosis::runs

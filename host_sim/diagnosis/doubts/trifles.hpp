// Causes that are found and of no consequence.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"
#include "shown.hpp"

namespace diagnosis::runs {

// Of a channel's share of noise power: by so much regression on it makes a gain look smaller, once in itself and once in what it
// is compared with.
constexpr double kAttenuation = 2;

// An error of a given mass, of a given spring or of a channel's gain that nobody could put right is none, however plainly
// records without noise show it; neither is what looks like it at its place.
void drop_trifles(const Task& task, Diagnosis& d);

// Takes back every cause whose 95 % interval contains nought, and what is said twice.
// base_follows: the rig as given follows the motion over its windows; where it does not something is missing, though none
// of these.
void drop_undetermined(Diagnosis& d, bool base_follows);

}  // namespace diagnosis::runs

// Whether a fitted model can be: what a rig is made of is not below nought, and its dampers take energy.
#pragma once
#include "../trial/attempt.hpp"

namespace diagnosis::runs {

// A mass, spring, damper or friction of the rig itself: below nought none can be.
bool is_number_of_rig(const ModelTerm& t);
// Whether such a number is wholly below nought, as its 95 % interval has it.
bool below_nought(const State& s);
// Whether a mass error of these leaves less than no mass, as its 95 % interval has it: at one tone a spring looks like that.
bool lightens_below_nought(const State& s, const std::vector<Candidate>& added);
// Whether such a number, surely above nought beside the one model, is below it in the other: what was added
// there does its work. Of another damping law on the same link nothing is said: before it was there the number did its work.
bool turns_a_number(const State& beside, const State& with);
// Whether these put more energy into a link somewhere along the motion of the windows fitted than all else that damps it takes, whatever
// values the 95 % intervals allow: a damper that differs with direction by more than it damps, one that falls below nought at the ends of
// the way or of a drift. P = w sum_i q_i f_i(u, w, t), w the link's rate. What the rig's own friction below nought puts in is not theirs.
bool drives_a_link(const Task& task, const State& s, const std::vector<Candidate>& added);
// Any of these: it comes behind what can be.
bool cannot_be(const Task& task, const State& beside, const Attempt& with);
// None of these, and no coefficient of its own may be nought.
bool can_stand(const Task& task, const State& beside, const Attempt& with);
// A gain of a sensor that no sensor, no turned cable and no slip of units has: never named.
bool is_no_sensors(const State& with, const std::vector<Candidate>& added);

}  // namespace diagnosis::runs

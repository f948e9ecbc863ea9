// A hidden mass so near a mode of the rig that a decay ends before the two have once been opposed.
#pragma once
#include "../trial/attempt.hpp"

namespace diagnosis::runs {

// Two tones that last for less than half a beat are one tone whose amplitude falls, as every law of damping makes it: of a motion that
// nothing drives such a mass is not told. False where the added causes hide no mass.
bool is_unresolved_mode(const Task& task, const State& with, const std::vector<Candidate>& added);

// By how much the two modes differ that a hidden mass takes most part in, Hz; 0: the model hides none, or has no other mode.
double split_Hz(const System& system, const Model& model);

// Seconds that a motion lasts: (sum x^2)^2 / sum x^4, which is 2/3 of a tone's samples, times 3/2.
double lasts_s(const Vec& motion, double step_s);

}  // namespace diagnosis::runs

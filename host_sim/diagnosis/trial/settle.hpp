// A model fitted over its windows: seen ones with its numbers, unseen ones with their states alone.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

constexpr double kMostlyNoise =
    0.5;  // of the squared residual: above it chance is the rival, below it other causes are

constexpr int kBaseSteps = 12, kTrialSteps = 6;  // of Gauss-Newton: to rest, and near enough to compare

// The model with its free numbers and states fitted over the seen windows; over the unseen ones its states alone.
void settle(const Task& task, State& s, int steps);

// Every so many windows of a state, fitted: where most of what is left is not noise a part of a long record tells
// causes apart as well as all of it. And what was found on one state, fitted to the windows of another; where they are the
// same it goes on from the states found.
State part_of(const Task& task, const State& whole, double noise);
State on_all(const Task& task, const State& whole, const State& found);
// Windows start from the measured motion again.
void forget_states(State& s);

}  // namespace diagnosis::runs

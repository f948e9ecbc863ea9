// Displacement, velocity and acceleration of one place from what is read of them.
#pragma once
#include "prepared.hpp"

namespace diagnosis::runs {

// What is slower than 2 half + 1 samples, by a moving mean that is taken so often.
struct Drift {
  Index half = 1;
  int passes = 1;
};
Vec without_drift(const Vec& z, const Drift& drift);

// Standard deviation of a slope that is taken over 2 half + 1 samples, per that of a white reading.
double slope_noise(Index half, double step_s);

// measured: displacement, velocity, acceleration; nullptr: not read. Smoothed over 2 half + 1 samples where a slope is taken; what is
// integrated has its drift taken off.
Guess guess_of(const std::vector<const Vec*>& measured, double step_s, Index half, const Drift& drift);

}  // namespace diagnosis::runs

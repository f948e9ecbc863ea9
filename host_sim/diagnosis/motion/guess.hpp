// Displacement, velocity and acceleration of one place from what is read of them.
#pragma once
#include "prepared.hpp"

namespace diagnosis::runs {

// measured: displacement, velocity, acceleration; nullptr: not read. Smoothed over 2 half + 1 samples where a slope is taken; what is
// integrated has what is slower than 2 slow + 1 samples taken off.
Guess guess_of(const std::vector<const Vec*>& measured, double step_s, Index half, Index slow);

Vec integral(const Vec& y, double step_s);

// What is slower than 2 slow + 1 samples: a moving mean, at the ends a straight line.
Vec slow_part(const Vec& z, Index slow);

}  // namespace diagnosis::runs

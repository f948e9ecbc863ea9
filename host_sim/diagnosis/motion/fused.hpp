// The motion that an accelerometer and a slower sensor of one place share.
#pragma once
#include "prepared.hpp"

namespace diagnosis::runs {

// Displacement and velocity as a Kalman smoother has them that integrates the acceleration, whose zero is unknown, and learns
// from displacement and velocity where they are read (one of them must be): each as far as its noise lets it. The slope of a
// displacement is noisy, an integral drifts; this has neither.
Guess fused_by_acceleration(const Vec* x, const Vec* v, const Vec& a, double step_s);

}  // namespace diagnosis::runs

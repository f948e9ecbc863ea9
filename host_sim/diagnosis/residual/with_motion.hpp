// Whether what a model leaves goes with the motion of its own window, or as well with that of any other.
#pragma once
#include "left.hpp"

namespace diagnosis::runs {

// The forces that a link or a mass could lack answer to the motion; what a sensor adds does not, whatever its colour.
// So each window's residual is put on columns of its own motion (forces that grow with elongation, rate, their squares
// and cubes, and acceleration, coefficients free in every window) and on those of other windows: what its own take more
// is no noise.
WithMotion with_motion(const System& system, const std::vector<Prepared>& records, const State& state);
// Of a fitted state with masses.
WithLoudness with_loudness(const std::vector<Prepared>& records, const State& state);

}  // namespace diagnosis::runs

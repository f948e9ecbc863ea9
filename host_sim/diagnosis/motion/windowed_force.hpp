// The force of a hammer.
#pragma once
#include "prepared.hpp"

namespace diagnosis::runs {

// A force and what the force window of modal testing takes off it.
struct Windowed {
  Vec force, off;
  Vec blow;  // 1 where a blow is, 0 between; empty: no window
};

// The force window of modal testing: between the blows of a hammer the force is nought, and what its channel shows there is noise,
// which would drive the simulated rig. Everything farther than a blow's own length from any blow becomes the channel's median.
Windowed windowed(const Vec& force);

// Standard deviation of a windowed force's noise, of samples thinned out by `by`: what shows between the blows is in them too.
Vec noise_in_blows(const Windowed& w, int by);

}  // namespace diagnosis::runs

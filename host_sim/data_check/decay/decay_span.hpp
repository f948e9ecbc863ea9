// A free decay within a record, and what makes one.
#pragma once
#include <cstddef>

namespace host_sim::data_check {

// Samples, the last one left out. clipped: up to its first.
struct DecaySpan {
  size_t from = 0, to = 0;
  bool clipped = false;
};

constexpr double kRises = 1.21;       // of the energy: a tenth of the motion, which noise and beats below it make
constexpr double kFalls = 0.25;       // the motion is halved
constexpr double kRestEnergy = 0.01;  // of the largest: a tenth of the motion, what a sensor shows of what rests

}  // namespace host_sim::data_check

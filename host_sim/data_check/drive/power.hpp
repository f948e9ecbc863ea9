// The work that forces do on a motion, about the means of both and as it was measured.
#pragma once
#include <vector>

namespace host_sim::data_check {

// A force and what it works on: their product is a power, or one weighted with the square of the frequency.
struct ForceAndMotion {
  std::vector<double> force, motion;
};

// A power factor is the power over the product of the rms values. About the means it knows no offset of a sensor; as measured it knows a
// motion that goes on one way.
struct Work {
  double about_means = 0.0;  // power factor
  double with_means = 0.0;   // the power as measured over the same rms values: no cosine, it may be beyond 1
  double as_measured = 0.0;  // power factor, means and all
  bool always_about_means = false, always_as_measured = false;  // given, in each of ten parts: chance makes one in 2^10
  bool runs_down = false;  // goes on one way, in each part more slowly: a flywheel that is braked gives what it has
};

// Of all pairs together: one force may brake what another one drives.
Work work_of(const std::vector<ForceAndMotion>& pairs);

}  // namespace host_sim::data_check

// Both sides of one pair of channels of a motion: what the lower one says of the upper one's means over spans, and these.
//
// Over a span of 2h samples the change of a displacement is the integral of the velocity, and so on:
//   (x[i+h] - x[i-h]) / (2 h T)          = mean of v over the span
//   (x[i+h] - 2 x[i] + x[i-h]) / (h T)^2 = mean of a over the span, weighted by a triangle
#pragma once
#include <cstddef>
#include <vector>

#include "host_sim/data_check/one_motion/integrals.hpp"

namespace host_sim::data_check {

// Over one span after the other. What the spans have in common is summed once.
class Sides {
 public:
  std::vector<double> from_lower, of_upper;  // centred at sample h + i, for every i or some

  Sides(const Channel& lower, const Channel& upper, double sample_period_s, Integrals& integrals);

  size_t samples() const { return lower_.size(); }

  void over(size_t h);
  // Some of them: each shares over nine tenths of its span with the next, or they are enough anyway. The step is no whole number,
  // so that no period of the motion keeps time with it.
  void here_and_there(size_t h);

 private:
  // The mean of a mean over h steps is a second difference of the integral's integral.
  void compare(size_t h, size_t count, double step);

  const std::vector<double>& lower_;
  bool twice_;
  double T_;
  const std::vector<double>& integral_;  // of the upper channel's, once or twice
};

}  // namespace host_sim::data_check

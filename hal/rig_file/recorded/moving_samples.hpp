// For how long a recorded motion lasts.
#pragma once
#include <algorithm>
#include <numeric>
#include <vector>

namespace rig_file {

// (sum of y^2)^2 / sum of y^4 of a record about its mean: of a band of noise a third of all samples, of a sine two thirds, of a decay
// exp(-t / tau) of some turns 2/3 tau. 0: nothing moves.
template <typename Number>
double moving_samples(const std::vector<Number>& y) {
  if (y.empty()) return 0.0;
  const double mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
  double squares = 0.0, fourths = 0.0;
  for (const Number value : y) {
    const double square = (value - mean) * (value - mean);
    squares += square, fourths += square * square;
  }
  return fourths > 0.0 ? squares * squares / fourths : 0.0;
}

// Of the record that moves least; those that do not move at all apart.
template <typename Number>
double fewest_moving_samples(const std::vector<std::vector<Number>>& records) {
  double fewest = 0.0;
  for (const std::vector<Number>& record : records)
    if (const double moving = moving_samples(record); moving > 0.0)
      fewest = fewest > 0.0 ? std::min(fewest, moving) : moving;
  return fewest;
}

}  // namespace rig_file

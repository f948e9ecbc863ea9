#include "hal/rig_file/recorded/motion_band.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/filter_design.hpp"

namespace rig_file {
namespace {

using Records = std::vector<std::vector<firmware::RawSample>>;

constexpr double kMostBeyond = 0.01;  // friction 0.5 % too small

double mean_square(const Records& records, int node, int quantity, const Impulse& h) {
  double squares = 0.0;
  size_t count = 0;
  for (const auto& record : records)
    for (size_t n = 0; n + h.size() <= record.size(); ++n, ++count) {
      double sum = 0.0;
      for (size_t k = 0; k < h.size(); ++k) sum += h[k] * record[n + k].code[node][quantity];
      squares += sum * sum;
    }
  return count == 0 ? 0.0 : squares / static_cast<double>(count);
}

// Power of the filter's output for the noise.
double noise_power(const Impulse& h, const ChannelNoise& noise) {
  double sum = 0.0;
  for (size_t i = 0; i < h.size(); ++i)
    for (size_t k = 0; k < h.size(); ++k) sum += h[i] * h[k] * noise.correlated(i < k ? k - i : i - k);
  return noise.deviation * noise.deviation * sum;
}

}  // namespace

bool moves_beyond_a_tenth(const Records& records, int node, int quantity, const ChannelNoise& noise) {
  const bool of_displacement = quantity == static_cast<int>(firmware::Quantity::kDisplacement);
  const Impulse slope = of_displacement ? first_difference() : Impulse{1.0}, passed = convolve(low_pass(0.0), slope);
  Impulse left(passed.size(), 0.0);
  std::copy(slope.begin(), slope.end(), left.begin() + kLowPassHalf);
  for (size_t k = 0; k < left.size(); ++k) left[k] -= passed[k];
  const double beyond =
      mean_square(records, node, quantity, left) - (1.0 + std::min(noise.doubt, 1.0)) * noise_power(left, noise);
  const double within = mean_square(records, node, quantity, passed) - noise_power(passed, noise);
  return within > 0.0 && beyond > kMostBeyond * within;
}

}  // namespace rig_file

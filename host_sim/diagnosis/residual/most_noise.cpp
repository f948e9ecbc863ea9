#include "most_noise.hpp"

#include <algorithm>

namespace diagnosis::runs {

double of_steps(const std::vector<Prepared>& records, size_t channel) {
  double largest = 0;
  for (const Prepared& p : records) largest = std::max(largest, p.traces[channel].step);
  return largest * largest / 12;
}

Vec most_noise(const std::vector<Prepared>& records) {
  const size_t channels = records[0].traces.size();
  Vec sum = Vec::Zero(static_cast<Index>(channels));
  Index samples = 0;
  for (const Prepared& p : records) {
    const Index from = moving_span(p, forced(records)).to, length = p.samples - from;
    if (static_cast<double>(length) * p.step_s < p.period_s) continue;
    for (size_t c = 0; c < channels; ++c) {
      const auto y = p.traces[c].y.segment(from, length);
      sum[static_cast<Index>(c)] += (y.array() - y.mean()).square().sum();
    }
    samples += length;
  }
  if (samples == 0) return Vec::Constant(static_cast<Index>(channels), 1e300);
  for (size_t c = 0; c < channels; ++c)
    sum[static_cast<Index>(c)] += static_cast<double>(samples) * of_steps(records, c);
  sum *= kBeyondNoise / static_cast<double>(samples);
  for (size_t c = 0; c < channels; ++c)
    if (records[0].traces[c].quantity == 2) sum[static_cast<Index>(c)] = 1e300;
  return sum;
}

}  // namespace diagnosis::runs

#include "host_sim/records/thin_out.hpp"

#include <cmath>
#include <numeric>

namespace host_sim {
namespace {

constexpr double kRollOff = 0.5;

// t in new sample periods.
double root_raised_cosine(double t) {
  if (t == 0.0) return 1.0 + kRollOff * (4.0 / M_PI - 1.0);
  const double steep = 4.0 * kRollOff * t;
  if (std::fabs(std::fabs(steep) - 1.0) < 1e-9) {
    const double angle = M_PI / (4.0 * kRollOff);
    return kRollOff / std::sqrt(2.0) * ((1.0 + 2.0 / M_PI) * std::sin(angle) + (1.0 - 2.0 / M_PI) * std::cos(angle));
  }
  return (std::sin(M_PI * t * (1.0 - kRollOff)) + steep * std::cos(M_PI * t * (1.0 + kRollOff))) /
         (M_PI * t * (1.0 - steep * steep));
}

std::vector<double> filtered(const std::vector<double>& values, const std::vector<double>& filter, size_t factor) {
  std::vector<double> result(thinned_samples(values.size(), factor));
  for (size_t i = 0; i < result.size(); ++i)
    result[i] = std::inner_product(filter.begin(), filter.end(), values.begin() + static_cast<long>(i * factor), 0.0);
  return result;
}

}  // namespace

std::vector<double> thinning_filter(size_t factor) {
  const size_t half = kThinningReach * factor;
  std::vector<double> filter(2 * half + 1);
  for (size_t k = 0; k < filter.size(); ++k)
    filter[k] = root_raised_cosine((static_cast<double>(k) - static_cast<double>(half)) / static_cast<double>(factor));
  const double sum = std::accumulate(filter.begin(), filter.end(), 0.0);
  for (double& tap : filter) tap /= sum;
  return filter;
}

size_t thinned_samples(size_t samples, size_t factor) {
  if (factor <= 1) return samples;
  const size_t length = 2 * kThinningReach * factor + 1;
  return samples < length ? 0 : (samples - length) / factor + 1;
}

Record thinned(const Record& record, size_t factor) {
  Record result = record;
  if (factor <= 1) return result;
  const std::vector<double> filter = thinning_filter(factor);
  for (Channel& channel : result.channels) channel.values = filtered(channel.values, filter, factor);
  result.sample_period_s = record.sample_period_s * static_cast<double>(factor);
  result.start_s = record.start_s + record.sample_period_s * static_cast<double>(kThinningReach * factor);
  result.left_out_before.reset();
  return result;
}

}  // namespace host_sim

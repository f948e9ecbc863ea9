#include "host_sim/data_check/statistics.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "host_sim/data_check/quantile.hpp"
#include "host_sim/records/value_step.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kNormalMedian = 0.67448975;  // of |x|, x standard normal

void difference(std::vector<double>& values) {
  for (size_t k = 0; k + 1 < values.size(); ++k) values[k] = values[k + 1] - values[k];
  if (!values.empty()) values.pop_back();
}

// Standard deviation of white noise from its differences of an even order: their variance is the noise's times the
// binomial coefficient (2n over n). By the median, so that bursts and edges do not count.
double noise_by_differences(const std::vector<double>& differences, int order) {
  std::vector<double> sizes(differences.size());
  for (size_t k = 0; k < sizes.size(); ++k) sizes[k] = std::abs(differences[k]);
  double binomial = 1.0;
  for (int i = 1; i <= order; ++i) binomial *= static_cast<double>(order + i) / static_cast<double>(i);
  return quantile(sizes, 0.5) / kNormalMedian / std::sqrt(binomial);
}

// Of the fourth and the sixth differences.
std::pair<double, double> noise_of(const std::vector<double>& values) {
  std::vector<double> differences = values;
  for (int i = 0; i < 4; ++i) difference(differences);
  const double fourth = noise_by_differences(differences, 4);
  for (int i = 0; i < 2; ++i) difference(differences);
  return {fourth, noise_by_differences(differences, 6)};
}

}  // namespace

std::string said_instant_s(const Record& record, double sample) {
  const double length_s = static_cast<double>(record.samples()) * record.sample_period_s;
  const double end_s = std::abs(record.start_s) + length_s;
  const int digits = std::clamp(3 + static_cast<int>(std::ceil(std::log10(end_s / length_s))), 3, 15);
  return fmt::format("{:.{}g}", record.start_s + sample * record.sample_period_s, digits);
}

std::vector<Run> equal_runs(const std::vector<double>& values, size_t shortest) {
  std::vector<Run> runs;
  for (size_t first = 0; first < values.size();) {
    size_t behind = first + 1;
    while (behind < values.size() && values[behind] == values[first]) ++behind;
    if (behind - first >= shortest) runs.push_back({first, behind - first});
    first = behind;
  }
  return runs;
}

MeanAndRms mean_and_rms(const std::vector<double>& values) {
  if (values.empty()) return {};
  const Eigen::Map<const Eigen::ArrayXd> of(values.data(), static_cast<Eigen::Index>(values.size()));
  const double mean = of.mean();
  return {mean, std::sqrt((of - mean).square().mean())};
}

Statistics statistics_of(const Channel& channel) {
  const std::vector<double>& values = channel.values;
  Statistics s;
  if (values.empty()) return s;
  const MeanAndRms first = mean_and_rms(values);
  s.mean = first.mean;
  s.rms = first.rms;
  const Eigen::Map<const Eigen::ArrayXd> of(values.data(), static_cast<Eigen::Index>(values.size()));
  s.lowest = of.minCoeff();
  s.highest = of.maxCoeff();
  if (s.lowest == s.highest) return s;
  const auto [bottom, top] = quantiles(values, 0.001, 0.999);
  s.range = top - bottom;
  s.resolution = value_step(channel);
  const auto [fourth, sixth] = noise_of(values);
  s.noise = std::max(fourth, s.resolution / std::sqrt(12.0));
  s.noisy = sixth > 0.5 * fourth && fourth > 0.3 * s.resolution;  // a smooth signal's sixth differences vanish
  double inside = 0.0, same = 0.0;
  for (size_t i = 1; i < values.size(); ++i) {
    if (values[i] <= bottom + 0.02 * s.range || values[i] >= top - 0.02 * s.range) continue;
    inside += 1.0;
    same += values[i] == values[i - 1] ? 1.0 : 0.0;
  }
  s.repeats = inside > 0.0 ? same / inside : 1.0;
  return s;
}

double mean_square_step(const std::vector<double>& values, size_t first, size_t end, size_t lag) {
  double sum = 0.0;
  for (size_t i = first; i + lag < end; ++i) sum += std::pow(values[i + lag] - values[i], 2);
  return end > first + lag ? sum / static_cast<double>(end - first - lag) : 0.0;
}

}  // namespace host_sim::data_check

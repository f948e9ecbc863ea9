#include "host_sim/data_check/measures/statistics.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/measures/quantile.hpp"
#include "host_sim/records/steps/value_step.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kNormalMedian = 0.67448975;  // of |x|, x standard normal

// What is left of the count.
size_t difference(double* values, size_t count) {
  if (count == 0) return 0;
  for (size_t k = 0; k + 1 < count; ++k) values[k] = values[k + 1] - values[k];
  return count - 1;
}

constexpr size_t kPart = 1024;
// Of a part's values.
void append_sizes(const double* values, size_t count, std::vector<double>& sizes) {
  double part[kPart];
  for (size_t k = 0; k < count; ++k) part[k] = std::abs(values[k]);
  sizes.insert(sizes.end(), part, part + count);
}

// Standard deviation of white noise from the sizes of its differences of an even order: their variance is the noise's times the
// binomial coefficient (2n over n). By the median, so that bursts and edges do not count.
double noise_by_differences(const std::vector<double>& sizes, int order) {
  double binomial = 1.0;
  for (int i = 1; i <= order; ++i) binomial *= static_cast<double>(order + i) / static_cast<double>(i);
  return quantile(sizes, 0.5) / kNormalMedian / std::sqrt(binomial);
}

// Of the fourth and the sixth differences. Part by part, so that a part stays near the processor from one difference to the next.
std::pair<double, double> noise_of(const std::vector<double>& values) {
  constexpr size_t kFourth = 4, kSixth = 6;
  std::vector<double> fourth, sixth;
  fourth.reserve(values.size()), sixth.reserve(values.size());
  for (size_t first = 0; first < values.size(); first += kPart) {
    double part[kPart + kSixth];
    size_t left = std::min(kPart + kSixth, values.size() - first);
    std::copy_n(values.data() + first, left, part);
    for (size_t i = 0; i < kFourth; ++i) left = difference(part, left);
    append_sizes(part, std::min(left, kPart), fourth);  // the last two are the next part's, too
    for (size_t i = kFourth; i < kSixth; ++i) left = difference(part, left);
    append_sizes(part, left, sixth);
  }
  return {noise_by_differences(fourth, kFourth), noise_by_differences(sixth, kSixth)};
}

double length_s(const Record& record) { return static_cast<double>(record.samples()) * record.sample_period_s; }

// In the file's own seconds, to `fine_s`.
std::string instant_s(const Record& record, double sample, double fine_s) {
  const double end_s = std::abs(record.start_s) + length_s(record);
  const int digits = std::clamp(static_cast<int>(std::ceil(std::log10(end_s / fine_s) - 1e-9)), 3, 15);
  return fmt::format("{:.{}g}", record.start_s + sample * record.sample_period_s, digits);
}

}  // namespace

std::string said_instant_s(const Record& record, double sample) {
  return instant_s(record, sample, 1e-3 * length_s(record));
}

std::string said_sample(const Record& record, size_t sample) {
  const std::string when = instant_s(record, static_cast<double>(sample), 0.1 * record.sample_period_s) + " s";
  if (!record.left_out_before) return when;
  return when + fmt::format(" (sample {})", *record.left_out_before + sample + 1);
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
  if (of.minCoeff() == of.maxCoeff()) return {values.front(), 0.0};
  const double mean = of.mean();
  return {mean, std::sqrt((of - mean).square().mean())};
}

bool is_constant(const Channel& channel) {
  return std::all_of(channel.values.begin(), channel.values.end(),
                     [&](double value) { return value == channel.values.front(); });
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
  const double low = bottom + 0.02 * s.range, high = top - 0.02 * s.range;
  size_t inside = 0, same = 0;
  for (size_t i = 1; i < values.size(); ++i) {
    const bool is_inside = !(values[i] <= low) & !(values[i] >= high);
    inside += is_inside ? 1 : 0;
    same += is_inside & (values[i] == values[i - 1]) ? 1 : 0;
  }
  s.repeats = inside > 0 ? static_cast<double>(same) / static_cast<double>(inside) : 1.0;
  return s;
}

double mean_square_step(const std::vector<double>& values, size_t first, size_t end, size_t lag) {
  double sum = 0.0;
  for (size_t i = first; i + lag < end; ++i) sum += std::pow(values[i + lag] - values[i], 2);
  return end > first + lag ? sum / static_cast<double>(end - first - lag) : 0.0;
}

std::vector<Statistics> statistics_of(const Record& record) {
  std::vector<Statistics> all;
  for (const Channel& channel : record.channels) all.push_back(statistics_of(channel));
  return all;
}

}  // namespace host_sim::data_check

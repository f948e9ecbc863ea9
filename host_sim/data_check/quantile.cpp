#include "host_sim/data_check/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace host_sim::data_check {
namespace {

constexpr size_t kSampled = 256;

double nth(double* values, size_t count, size_t rank) {
  std::nth_element(values, values + rank, values + count);
  return values[rank];
}
double nth_of_all(const std::vector<double>& values, size_t rank) {
  std::vector<double> copy(values);
  return nth(copy.data(), copy.size(), rank);
}

struct Bracket {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};
// The places in the sample on either side of the rank's: four standard deviations of where it falls, and two for ranks at an end.
Bracket bracket_of(const std::vector<double>& values, size_t rank) {
  const double share = static_cast<double>(rank) / static_cast<double>(values.size());
  const auto margin = static_cast<size_t>(2.0 + 4.0 * std::sqrt(kSampled * share * (1.0 - share)));
  std::vector<double> sample(kSampled);
  for (size_t i = 0; i < kSampled; ++i) sample[i] = values[i * values.size() / kSampled];
  std::sort(sample.begin(), sample.end());
  const size_t place = rank * kSampled / values.size();
  Bracket bracket;
  if (place >= margin) bracket.low = sample[place - margin];
  if (place + margin < kSampled) bracket.high = sample[place + margin];
  return bracket;
}

double at_rank(const std::vector<double>& values, size_t rank) {
  if (values.size() < 8 * kSampled) return nth_of_all(values, rank);
  const auto [low, high] = bracket_of(values, rank);
  const std::unique_ptr<double[]> inside(new double[values.size()]);
  size_t below = 0, count = 0;
  for (const double value : values) {  // no branch: which side a value is on cannot be predicted
    inside[count] = value;
    below += value < low ? 1 : 0;
    count += static_cast<size_t>(value >= low) & static_cast<size_t>(value <= high);
  }
  if (rank < below || rank >= below + count) return nth_of_all(values, rank);  // a sample unlike the rest
  return nth(inside.get(), count, rank - below);
}

}  // namespace

double quantile(const std::vector<double>& values, double q) {
  return values.empty() ? 0.0 : at_rank(values, static_cast<size_t>(q * static_cast<double>(values.size() - 1)));
}

std::pair<double, double> quantiles(const std::vector<double>& values, double low, double high) {
  return {quantile(values, low), quantile(values, high)};
}

}  // namespace host_sim::data_check

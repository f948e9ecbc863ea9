#include "host_sim/data_check/measures/quantile.hpp"

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

struct Bracket {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};
struct Inside {
  size_t count = 0, below = 0;
};
// The places in the sample on either side of the rank's: four standard deviations of where it falls, and two for ranks at an end.
Bracket bracket_of(const double* values, size_t count, size_t rank) {
  const double share = static_cast<double>(rank) / static_cast<double>(count);
  const auto margin = static_cast<size_t>(2.0 + 4.0 * std::sqrt(kSampled * share * (1.0 - share)));
  double sample[kSampled];
  for (size_t i = 0; i < kSampled; ++i) sample[i] = values[i * count / kSampled];
  const size_t place = rank * kSampled / count;
  Bracket bracket;
  if (place >= margin) bracket.low = nth(sample, kSampled, place - margin);
  if (place + margin < kSampled) bracket.high = nth(sample, kSampled, place + margin);
  return bracket;
}

// Those inside to `room`, and how many are below. Of a bracket that is open they are few, and one comparison tells them; of any other
// it cannot be predicted which side a value is on: no branch.
Inside take_inside(const double* values, size_t count, const Bracket& bracket, double* room) {
  const auto [low, high] = bracket;
  Inside inside;
  if (std::isinf(low) || std::isinf(high)) {
    for (size_t i = 0; i < count; ++i)
      if (std::isinf(low) ? values[i] <= high : values[i] >= low) room[inside.count++] = values[i];
    inside.below = std::isinf(low) ? 0 : count - inside.count;
    return inside;
  }
  for (size_t i = 0; i < count; ++i) {
    const double value = values[i];
    room[inside.count] = value;
    inside.below += value < low ? 1 : 0;
    inside.count += static_cast<size_t>(value >= low) & static_cast<size_t>(value <= high);
  }
  return inside;
}

double at_rank(const double* values, size_t count, size_t rank) {
  const std::unique_ptr<double[]> room(new double[count]);
  if (count >= 8 * kSampled) {
    const Inside inside = take_inside(values, count, bracket_of(values, count, rank), room.get());
    const bool holds = rank >= inside.below && rank < inside.below + inside.count;  // else a sample unlike the rest
    if (holds && 2 * inside.count <= count) return at_rank(room.get(), inside.count, rank - inside.below);
  }
  std::copy(values, values + count, room.get());
  return nth(room.get(), count, rank);
}

}  // namespace

double quantile(const std::vector<double>& values, double q) {
  return values.empty()
             ? 0.0
             : at_rank(values.data(), values.size(), static_cast<size_t>(q * static_cast<double>(values.size() - 1)));
}

std::pair<double, double> quantiles(const std::vector<double>& values, double low, double high) {
  return {quantile(values, low), quantile(values, high)};
}

}  // namespace host_sim::data_check

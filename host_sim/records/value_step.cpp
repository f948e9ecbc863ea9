#include "host_sim/records/value_step.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/records/in_order.hpp"

namespace host_sim {
namespace {

constexpr size_t kLooked = 10000;  // steps, evenly spread: enough to see which is the usual one
constexpr double kOftenest =
    0.25;  // of the steps are alike where a coarse grid is slowly crossed, next to none elsewhere
constexpr double kAll = 0.99, kMost = 0.95;  // of the steps are whole: beside a few values that were written in full

// Of a unit, the decimal that it was rounded to: steps by chance then lie at three tenths of all places, and 20 of them
// all there are no chance. Beyond so many units a step says no more.
constexpr double kPlaceOfUnit = 0.15, kMostMultiples = 32.0;

// Differences between neighbours that are more than the rounding of the values.
std::vector<double> steps_of(const std::vector<double>& values) {
  std::vector<double> steps;
  steps.reserve(values.size());
  for (size_t i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    if (step > 1e-12 * std::abs(values[i])) steps.push_back(step);
  }
  return steps;
}

// The unit as all whole multiples of it tell it, where that share of the steps is whole; else 0.
double whole_unit(const std::vector<double>& steps, double unit, double share) {
  size_t counted = 0, whole = 0;
  double sum = 0.0, count = 0.0;
  for (const double step : steps) {
    const double multiple = step / unit;
    if (multiple > 50.5) continue;  // beyond, the unit's own rounding adds up
    const double nearest = std::nearbyint(multiple);
    ++counted;
    if (nearest >= 1.0 && std::abs(multiple - nearest) < 0.01 * nearest + 0.01) {
      ++whole;
      sum += multiple;
      count += nearest;
    }
  }
  const bool quantised = counted >= 20 && static_cast<double>(whole) >= share * static_cast<double>(counted);
  return quantised ? unit * sum / count : 0.0;
}

// The unit of steps that were written in decimals too coarse for it, as 1/11 degree is in hundredths: all steps are whole
// multiples of it but for `place`, the last decimal. The first guess is off by a place; multiples tell it ever better.
double rounded_unit(const std::vector<double>& steps) {
  const std::vector<double> sorted = in_order(steps);
  const double smallest = sorted.front();
  double place = smallest;
  for (size_t i = 1; i < sorted.size(); ++i)
    if (const double apart = sorted[i] - sorted[i - 1]; apart > 1e-6 * smallest) place = std::min(place, apart);
  if (place > kPlaceOfUnit * smallest) return 0.0;
  double unit = smallest + 0.5 * place;
  for (double most = 1.0; most <= kMostMultiples; most *= 2.0) {
    size_t counted = 0, whole = 0;
    double sum = 0.0, count = 0.0;
    for (const double step : sorted) {
      const double nearest = std::nearbyint(step / unit);
      if (nearest > most) break;
      ++counted;
      if (nearest < 1.0 || std::abs(step - nearest * unit) > 1.1 * place) continue;
      ++whole, sum += step, count += nearest;
    }
    if (static_cast<double>(whole) < kAll * static_cast<double>(counted) || count == 0.0) return 0.0;
    unit = sum / count;
  }
  return unit;
}

// The step that a quarter of all are, within a thousandth; 0 where there is none.
double usual_step(const std::vector<double>& steps) {
  std::vector<double> some;
  const size_t stride = steps.size() / kLooked + 1;
  for (size_t i = 0; i < steps.size(); i += stride) some.push_back(steps[i]);
  some = in_order(some);
  const auto alike = static_cast<size_t>(kOftenest * static_cast<double>(some.size()));
  for (size_t i = 0; i + alike < some.size(); ++i)
    if (some[i + alike] <= 1.001 * some[i]) return some[i + alike / 2];
  return 0.0;
}

}  // namespace

double value_step(const std::vector<double>& values) {
  const std::vector<double> steps = steps_of(values);
  if (steps.size() < 20) return 0.0;
  if (const double unit = whole_unit(steps, *std::min_element(steps.begin(), steps.end()), kAll); unit > 0.0)
    return unit;
  const double usual = usual_step(steps);
  if (const double unit = usual > 0.0 ? whole_unit(steps, usual, kMost) : 0.0; unit > 0.0) return unit;
  return rounded_unit(steps);
}

double value_step(const Channel& channel) {
  return channel.recorded_step > 0.0 ? channel.recorded_step : value_step(channel.values);
}

}  // namespace host_sim

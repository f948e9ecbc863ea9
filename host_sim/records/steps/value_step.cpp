#include "host_sim/records/steps/value_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "host_sim/records/steps/levels.hpp"
#include "host_sim/records/times/in_order.hpp"

namespace host_sim {
namespace {

constexpr size_t kLooked = 10000;  // steps, evenly spread: enough to see which is the usual one
constexpr double kOftenest =
    0.25;  // of the steps are alike where a coarse grid is slowly crossed, next to none elsewhere
constexpr double kAll = 0.99, kMost = 0.95;  // of the steps are whole: beside a few values that were written in full

// Of a unit, the decimal that it was rounded to: steps by chance then lie at three tenths of all places, and 20 of them
// all there are no chance. Beyond so many units a step says no more.
constexpr double kPlaceOfUnit = 0.15, kMostMultiples = 32.0;
constexpr double kMostRounded =
    (1.0 + 0.5 * kPlaceOfUnit) * (kMostMultiples + 1.0);  // times the smallest: no step beyond is looked at
constexpr size_t kFew = 1024;                             // beside steps of whole units they are more

// Differences between neighbours that are more than the rounding of the values.
std::vector<double> steps_of(const std::vector<double>& values) {
  std::vector<double> steps(values.size());
  size_t count = 0;
  for (size_t i = 1; i < values.size(); ++i) {
    const double step = steps[count] = std::abs(values[i] - values[i - 1]);
    count += step > 1e-12 * std::abs(values[i]) ? 1 : 0;
  }
  steps.resize(count);
  return steps;
}

// Four by four: the smaller of two waits for the one before.
double smallest_of(const std::vector<double>& steps) {
  std::array<double, 4> least;
  least.fill(steps.front());
  size_t i = 0;
  for (; i + least.size() <= steps.size(); i += least.size())
    for (size_t k = 0; k < least.size(); ++k) least[k] = std::min(least[k], steps[i + k]);
  for (; i < steps.size(); ++i) least[0] = std::min(least[0], steps[i]);
  return *std::min_element(least.begin(), least.end());
}

// The unit as all whole multiples of it tell it, where that share of the steps is whole; else 0.
double whole_unit(const std::vector<double>& steps, double unit, double share) {
  size_t counted = 0, whole = 0;
  double sum = 0.0, count = 0.0;
  const double others =
      (1.0 - share) * static_cast<double>(steps.size()) + 1.0;  // that many are too many, whatever follows
  for (const double step : steps) {
    if (step > 51.0 * unit) continue;
    const double multiple = step / unit;
    if (multiple > 50.5) continue;  // beyond, the unit's own rounding adds up
    const double nearest = std::nearbyint(multiple);
    ++counted;
    if (nearest >= 1.0 && std::abs(multiple - nearest) < 0.01 * nearest + 0.01) {
      ++whole;
      sum += multiple;
      count += nearest;
    } else if (static_cast<double>(counted - whole) > others) {
      return 0.0;
    }
  }
  const bool quantised = counted >= 20 && static_cast<double>(whole) >= share * static_cast<double>(counted);
  return quantised ? unit * sum / count : 0.0;
}

// The smallest difference between two of sorted steps that is more than the rounding of values; of one step itself.
double least_apart(const std::vector<double>& sorted) {
  double least = sorted.front();
  for (size_t i = 1; i < sorted.size(); ++i)
    if (const double apart = sorted[i] - sorted[i - 1]; apart > 1e-6 * sorted.front()) least = std::min(least, apart);
  return least;
}

// Whether rounded_unit() finds none, as of nearly all measured signals, told by the smallest steps alone: the last decimal is at most what
// lies between two of these, and the unit with it.
bool surely_none(const std::vector<double>& steps, double smallest) {
  std::vector<double> few;
  for (const double step : steps) {
    if (step > kMostRounded * smallest) continue;
    if (few.size() == kFew) return false;
    few.push_back(step);
  }
  std::sort(few.begin(), few.end());
  const double place = std::min(least_apart(few), kPlaceOfUnit * smallest);  // beyond, there is none
  double lowest = smallest, highest = smallest + 0.5 * place;                // between which the unit is
  for (double most = 1.0; most <= kMostMultiples; most *= 2.0) {
    size_t counted = 0, off = 0;  // at the most, at the least
    for (const double step : few) {
      const double nearest = std::nearbyint(step / highest);
      if (nearest > most) break;
      ++counted;
      if (nearest != std::nearbyint(step / lowest)) continue;
      if (step < nearest * lowest - 1.2 * place || step > nearest * highest + 1.2 * place) ++off;
    }
    if (2.0 * (1.0 - kAll) * static_cast<double>(counted) < static_cast<double>(off)) return true;
    if (counted > 1) return false;  // the unit is their mean
    lowest = highest = smallest;
  }
  return false;
}

// The unit of steps that were written in decimals too coarse for it, as 1/11 degree is in hundredths: all steps are whole
// multiples of it but for `place`, the last decimal. The first guess is off by a place; multiples tell it ever better.
double rounded_unit(const std::vector<double>& steps, double smallest) {
  if (surely_none(steps, smallest)) return 0.0;
  const std::vector<double> sorted = in_order(steps);
  const double place = least_apart(sorted);
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

// Whether `alike` steps and one more may lie within a thousandth of each other: then two neighbouring ones of drawers hold them that are
// two thousandths wide and more (the exponents of two and 8 bits behind the point; many drawers share one counter).
bool may_be_alike(const std::vector<double>& steps, size_t alike) {
  constexpr size_t kCounters = 4096, kBitsLeftOut = 44;
  std::array<uint32_t, kCounters> held{};
  for (const double step : steps) {
    uint64_t bits = 0;
    std::memcpy(&bits, &step, sizeof bits);
    ++held[(bits >> kBitsLeftOut) % kCounters];
  }
  for (size_t k = 0; k < kCounters; ++k)
    if (held[k] + held[(k + 1) % kCounters] > alike) return true;
  return false;
}

// The step that a quarter of all are, within a thousandth; 0 where there is none.
double usual_step(const std::vector<double>& steps) {
  std::vector<double> some;
  const size_t stride = steps.size() / kLooked + 1;
  for (size_t i = 0; i < steps.size(); i += stride) some.push_back(steps[i]);
  const auto alike = static_cast<size_t>(kOftenest * static_cast<double>(some.size()));
  if (!may_be_alike(some, alike)) return 0.0;
  some = in_order(some);
  for (size_t i = 0; i + alike < some.size(); ++i)
    if (some[i + alike] <= 1.001 * some[i]) return some[i + alike / 2];
  return 0.0;
}

}  // namespace

double value_step(const std::vector<double>& values) {
  const std::vector<double> steps = steps_of(values);
  if (steps.size() < 20) return 0.0;
  const double smallest = smallest_of(steps);
  if (const double unit = whole_unit(steps, smallest, kAll); unit > 0.0) return unit;
  if (const double usual = usual_step(steps); usual > 0.0) {
    if (const double unit = whole_unit(steps, usual, kMost); unit > 0.0) return unit;
    if (on_few_levels(values, usual)) return usual;
  }
  return rounded_unit(steps, smallest);
}

double value_step(const Channel& channel) {
  return channel.recorded_step > 0.0 ? channel.recorded_step : value_step(channel.values);
}

}  // namespace host_sim

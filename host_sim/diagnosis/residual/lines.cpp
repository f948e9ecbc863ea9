#include "lines.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/records/median.hpp"

namespace diagnosis::runs {
namespace {

constexpr Index kNear = 4;     // bins on either side that one realisation of a noise is averaged over
constexpr Index kLeakage = 2;  // bins that a line between two of them spreads over, on either side

double level_of(const Vec& power, Index from, Index to) {
  std::vector<double> list;
  for (Index k = std::max<Index>(1, from); k <= std::min(power.size() - 1, to); ++k) list.push_back(power[k]);
  return host_sim::median(list) / kMedianOfSpread;
}

bool any_drives(const std::vector<Vec>& driving, Index i) {
  return std::any_of(driving.begin(), driving.end(), [&](const Vec& p) {
    return i >= 1 && i + 1 < p.size() &&
           over_level_around(p, i - 1) + over_level_around(p, i) + over_level_around(p, i + 1) > kLine;
  });
}

// Whether no other line comes near that of a bin.
bool stands_alone(const Vec& power, Index peak) {
  for (Index i = 1; i < power.size(); ++i)
    if (std::abs(i - peak) > kLeakage && kAlone * power[i] > power[peak] && over_level_around(power, i) > kLine)
      return false;
  return true;
}

}  // namespace

double over_level_around(const Vec& power, Index i, const Vec& made) {
  double level =
      std::max(level_of(power, i - kAround, i - kLeakage - 1), level_of(power, i + kLeakage + 1, i + kAround));
  if (made.size() > 0) {
    const Index from = std::max<Index>(1, i - kNear), to = std::min(made.size() - 1, i + kNear);
    level = std::max(level, made.segment(from, to - from + 1).mean());
  }
  return power[i] / std::max(1e-300, level);
}

bool of_mains(double hertz, double bin_Hz) {
  for (double mains : {50.0, 60.0}) {
    const double order = std::round(hertz / mains);
    if (order >= 1 && std::abs(hertz - order * mains) < kMainsWidth_Hz * order + 2 * bin_Hz) return true;
  }
  return false;
}

void highest_lines(const Vec& power, const Vec& by_drives, Index from, Index to, double bin_Hz,
                   const std::vector<Vec>& driving, Left& left) {
  for (Index i = std::max<Index>(from, 3); i < std::min(to, power.size()); ++i) {
    if (power[i] < power[i - 1] || (i + 1 < power.size() && power[i] < power[i + 1])) continue;
    if (of_mains(static_cast<double>(i) * bin_Hz, bin_Hz)) continue;
    const double line = over_level_around(power, i, by_drives);
    left.line = std::max(left.line, line);
    if (!any_drives(driving, i)) left.foreign_line = std::max(left.foreign_line, line);
  }
}

Hum hum_in(const Vec& power, size_t samples, double step_s, const std::vector<Vec>& driving) {
  Hum best;
  const double n = static_cast<double>(samples), bin_Hz = 1 / (n * step_s);
  for (double mains : {50.0, 60.0}) {
    const Index from = std::max<Index>(3, static_cast<Index>((mains - kMainsWidth_Hz) / bin_Hz)),
                to = std::min(power.size() - 1 - kLeakage, static_cast<Index>((mains + kMainsWidth_Hz) / bin_Hz) + 1);
    if (from > to) continue;
    Index peak = from;
    for (Index i = from; i <= to; ++i)
      if (power[i] > power[peak]) peak = i;
    const double over = over_level_around(power, peak);
    if (over < kLine || !stands_alone(power, peak)) continue;
    // a sine of amplitude A has the power A^2 n / 4
    const double line = power.segment(peak - kLeakage, 2 * kLeakage + 1).sum() * (1 - 1 / over);
    const double amplitude = 2 * std::sqrt(line / n);
    if (amplitude > best.amplitude) best = {mains, amplitude, over, any_drives(driving, peak)};
  }
  return best;
}

}  // namespace diagnosis::runs

#include "host_sim/data_check/spikes/misfit.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/measures/quantile.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kNear = 50;  // samples on each side that say what is usual

// Of ringings of 2.7 to 8 samples a period 236 in 1440 were taken for spikes, 74 with a fifth of the largest misfit over 16 samples.
// No spike was lost: one beside noise stands off by 8 standard deviations, whose median is a twelfth of that, and a second one
// 10 samples away makes 7 of the 16 (tests/data_check/ringing_test.cpp).
constexpr size_t kBeside = 16;
constexpr double kOfTheRinging = 0.2;
constexpr size_t kTouched = 2;  // samples beside a spike, whose misfit is the spike's

}  // namespace

std::vector<double> misfits(const std::vector<double>& x) {
  std::vector<double> out(x.size(), 0.0);
  for (size_t i = 2; i + 2 < x.size(); ++i)
    out[i] = std::abs(x[i] - (4.0 * (x[i - 1] + x[i + 1]) - x[i - 2] - x[i + 2]) / 6.0);
  return out;
}

double usual_near(const std::vector<double>& misfit, size_t i, size_t width) {
  std::vector<double> around;
  for (size_t k = i > kNear ? i - kNear : 0; k < std::min(misfit.size(), i + width + kNear); ++k)
    if (k + 4 < i || k > i + width + 4) around.push_back(misfit[k]);
  return quantile(around, 0.5) / 0.6745;
}

bool is_of_a_ringing(const std::vector<double>& misfit, size_t first, size_t width) {
  const auto at = [&](size_t k) { return misfit.begin() + static_cast<std::ptrdiff_t>(std::min(k, misfit.size())); };
  const auto median = [&](size_t from, size_t to) {
    const std::vector<double> side(at(from), at(to));
    return side.empty() ? 0.0 : quantile(side, 0.5);
  };
  const size_t end = first + width, before = first > kTouched ? first - kTouched : 0;
  const double left = median(before > kBeside ? before - kBeside : 0, before),
               right = median(end + kTouched, end + kTouched + kBeside);
  return std::max(left, right) > kOfTheRinging * *std::max_element(at(first), at(end));
}

}  // namespace host_sim::data_check

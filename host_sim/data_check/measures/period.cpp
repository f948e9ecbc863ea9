#include "host_sim/data_check/measures/period.hpp"

#include <algorithm>

#include "host_sim/data_check/measures/statistics.hpp"
#include "host_sim/records/median.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kSwings = 0.5;  // of the rms: turns beyond it on both sides are swings, not noise

}  // namespace

double period_of(const std::vector<double>& y) {
  const auto about = mean_and_rms(y);
  std::vector<double> half;
  int side = 0;
  size_t since = 0;
  for (size_t i = 0; i < y.size(); ++i) {
    const double off = y[i] - about.mean;
    const int now = off > kSwings * about.rms ? 1 : off < -kSwings * about.rms ? -1 : 0;
    if (now == 0 || now == side) continue;
    if (side != 0) half.push_back(static_cast<double>(i - since));
    side = now, since = i;
  }
  return half.size() < 4 ? 0.0 : 2.0 * median(std::move(half));
}

double slowest_period_of(const std::vector<double>& y, double share) {
  constexpr size_t kParts = 8;
  std::vector<std::vector<double>> parts;
  double loudest = 0.0;
  for (size_t k = 0; k < kParts; ++k) {
    const auto at = [&](size_t part) { return y.begin() + static_cast<std::ptrdiff_t>(part * y.size() / kParts); };
    parts.emplace_back(at(k), at(k + 1));
    loudest = std::max(loudest, mean_and_rms(parts.back()).rms);
  }
  double slowest = 0.0;
  for (const std::vector<double>& part : parts)
    if (const double rms = mean_and_rms(part).rms; rms * rms >= share * loudest * loudest)
      slowest = std::max(slowest, period_of(part));
  return slowest;
}

}  // namespace host_sim::data_check

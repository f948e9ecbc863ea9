#include "error_sums.hpp"

#include <algorithm>

namespace diagnosis::runs {
namespace {

constexpr double kMostPercent = 1000;  // more says no more

double capped(double percent) { return std::isfinite(percent) ? std::min(percent, kMostPercent) : kMostPercent; }

constexpr double kSteady = 1e-9;  // of the force's square: a step of a converter of 15 bits

}  // namespace

void count_steady_force(DofErrors& of) {
  if (!(of.x.count > 0) || of.x.variance() > kSteady * of.force / of.x.count) return;
  for (ErrorSums* sums : {&of.x, &of.v, &of.a}) sums->motion = of.force;
}

Score score_of(const std::vector<DofErrors>& dofs, bool finite) {
  Score score;
  for (const DofErrors& of : dofs) {
    const bool any = finite && of.x.count > 0;
    score.nrmse_percent.push_back(any ? capped(100 * std::sqrt(of.x.ratio())) : kMostPercent);
    score.velocity_percent.push_back(any ? capped(100 * std::sqrt(of.v.ratio())) : kMostPercent);
    score.mse_percent.push_back(any ? capped(100 * of.a.ratio()) : kMostPercent);
    const double variance = std::max(of.x.variance(), 1e-300);
    score.by_steps_percent.push_back(any ? capped(100 * std::sqrt(of.steps / variance)) : 0);
    const double beyond_steps = any ? capped(100 * std::sqrt(of.x.ratio_beyond(of.steps))) : kMostPercent;
    const double worst = any && !of.x.shows(of.noise) ? 0 : beyond_steps;
    const double beyond = std::max(0.0, of.x.mean_error() - of.noise - of.driven.mean_error()) / variance;
    if (any && of.x.shows(of.noise))
      score.beyond_noise_percent = std::max(score.beyond_noise_percent, capped(100 * std::sqrt(beyond)));
    if (worst <= score.worst_percent) continue;
    score.worst_percent = worst;
    score.by_drives_percent = capped(100 * std::sqrt(of.driven.mean_error() / variance));
  }
  return score;
}

}  // namespace diagnosis::runs

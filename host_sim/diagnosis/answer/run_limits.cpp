#include "run_limits.hpp"

#include <algorithm>
#include <cmath>

#include "../sensors/sensor_check.hpp"
#include "../terms/naming.hpp"

namespace diagnosis::runs {
namespace {

// In standard deviations of the windows fitted: it has to be sure there and to pay on those that are left, which are fewer, or
// to be beyond doubt where those cannot tell.
double needed_deviations(const State& base) {
  double seen = 0, unseen = 0;
  for (const Window& w : base.seen) seen += static_cast<double>(w.length);
  for (const Window& w : base.unseen) unseen += static_cast<double>(w.length);
  const double sure = seen_in_95_of_100(kSure * kSure);
  const double alone = seen_in_95_of_100(kNamed * kNamed);
  if (!(unseen > 0)) return alone;
  return std::clamp(seen_in_95_of_100(kByChance * kByChance) * std::sqrt(seen / unseen), sure, alone);
}

}  // namespace

void raise_limits(const Task& task, const State& base, std::vector<DetectionLimit>& limits) {
  if (!base.fit.ok || limits.empty()) return;
  std::vector<Candidate> candidates = candidates_beside(task.system, base.model, task.records, false);
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [](const Candidate& c) { return c.host >= 0 || c.complexity > 0; }),
                   candidates.end());  // no coefficient of its own, or one of another shape
  const Screen s = screen(task.system, task.records, base.model, base.seen, base.fit, candidates, 0);
  const double deviations = needed_deviations(base);
  for (const Screened& one : s.singles) {
    const Candidate& c = candidates[one.candidate];
    if (one.value.empty() || !(std::abs(one.z) > 0)) continue;
    const double needed = deviations * std::abs(one.value[0] / one.z);
    const NamedPlace place{word_of(c.terms[0].kind), place_of(task.system, c.terms[0], FusedRecord())};
    for (DetectionLimit& limit : limits) {
      if (limit.effect != place.effect || limit.where != place.where || !(needed > limit.strength)) continue;
      limit.percent_of_damping_force *= needed / limit.strength, limit.strength = needed;
    }
  }
}

}  // namespace diagnosis::runs

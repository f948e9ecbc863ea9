#include "needless.hpp"

#include <algorithm>
#include <cmath>

#include "../trial/attempt.hpp"
#include "../trial/paired.hpp"
#include "shown.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kFurtherShare = 2e-3;  // of what the causes named before have brought, that a further one must

bool stands_alone(const State& s, const Named& n) {
  const int at = static_cast<int>(
      std::find_if(s.model.begin(), s.model.end(),
                   [&](const ModelTerm& t) { return t.added && n.candidate.terms[0].same_place(t.term); }) -
      s.model.begin());
  return n.candidate.terms.size() == 1 && n.candidate.host < 0 &&
         std::none_of(s.model.begin(), s.model.end(), [&](const ModelTerm& t) { return t.host == at; });
}

State without(const Task& task, const State& now, const Named& n) {
  State s = now;
  const auto gone = std::find_if(s.model.begin(), s.model.end(), [&](const ModelTerm& t) {
    return t.added && n.candidate.terms[0].same_place(t.term);
  });
  const int at = static_cast<int>(gone - s.model.begin());
  s.model.erase(gone);
  for (ModelTerm& t : s.model) t.host -= t.host > at;
  settle(task, s, kBaseSteps);
  return s;
}

constexpr double kNoTime = 1e-3;  // of the time that bristles take to bend

}  // namespace

double motion_over_error(const Task& task, const State& base) {
  const Evaluator e(task.system, base.model, task.records);
  double sum = 0;
  const Index channels = base.fit.mean_square.size();
  for (Index c = 0; c < channels; ++c) {
    double motion = 0;
    for (size_t r = 0; r < task.records.size(); ++r)
      motion = std::max(motion, rms_about_mean(e.traces(r)[static_cast<size_t>(c)].y));
    sum += motion * motion / base.fit.mean_square[c];
  }
  return sum / static_cast<double>(std::max<Index>(1, channels));
}

bool takes_little(double error_before, double error_with, double motion) {
  return error_before - error_with < kFurtherShare * std::min(1 - error_before, motion);
}

void drop_needless(const Task& task, const State& base, State& now, std::vector<Named>& named) {
  for (size_t i = 0; named.size() > 1 && now.fit.ok && i < named.size();) {
    if (!stands_alone(now, named[i])) {
      ++i;
      continue;
    }
    const State fewer = without(task, now, named[i]);
    const bool unshown = all_shown(task, now.model) && !all_shown(task, fewer.model);
    if (!fewer.fit.ok || unshown ||
        (paired_z(fewer.fit, now.fit) > kByChance &&
         !takes_little(error_over(fewer.fit, base.fit), error_over(now.fit, base.fit),
                       motion_over_error(task, base)))) {
      ++i;
      continue;
    }
    now = fewer;
    named.erase(named.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void drop_idle_damping(const Task& task, State& now, std::vector<Named>& named) {
  bool any = false;
  for (ModelTerm& t : now.model) {
    if (!t.added || t.term.kind != Kind::kPresliding || !t.shape2_free) continue;
    if (std::abs(t.term.shape2) * rate_of(task.system, task.records, t.term.link) > kNoTime * t.term.shape) continue;
    t.term.shape2 = 0, t.shape2_free = false, any = true;
  }
  if (!any) return;
  settle(task, now, kBaseSteps);
  for (Named& n : named)
    if (n.candidate.terms[0].kind == Kind::kPresliding) keep_shape(now.model, n.candidate);
}

}  // namespace diagnosis::runs

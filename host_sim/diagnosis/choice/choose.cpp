#include <algorithm>
#include <cmath>

#include "../answer/answer.hpp"
#include "../fit/start.hpp"
#include "round.hpp"
#include "warming.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kMostCauses = 4;
constexpr double kFurtherShare = 2e-3;    // of what the causes named before have brought, that a further one must
constexpr double kTogether = 0.5;         // of what one cause leaves, that dampers which drift together may
constexpr double kLinear = 0.25;          // error over motion up to which a linearisation is trusted
constexpr double kShortestHorizon = 0.2;  // periods
constexpr double kNearEnough_percent =
    0.3;                                 // of the motion, free run on unseen data: sensors are not better calibrated
constexpr double kRight_percent = 0.05;  // where noise may hide a cause: no sensor tells it from the truth
constexpr double kBorneOut = 3;          // standard errors, of what another test has found

void lay(const Task& task, double periods, State& s) {
  const bool apart = task.training < task.records.size();
  s.seen.clear(), s.unseen.clear();
  for (Window& w : lay_windows(task.records, periods, apart ? 0 : 0.3)) {
    const bool unseen = apart ? w.record >= task.training : w.unseen;
    (unseen ? s.unseen : s.seen).push_back(w);
  }
}

// Windows twice as long, up to `most` periods, as long as the fitted model follows them: what was fitted over short
// ones starts nearer than first values do. True where any were longer.
bool widen(const Task& task, double most, double& periods, State& s) {
  bool any = false;
  while (periods < 0.75 * most) {
    State longer = s;
    lay(task, std::min(most, 2 * periods), longer);
    if (longer.unseen.empty() != s.unseen.empty()) return any;
    settle(task, longer, kBaseSteps);
    if (!longer.fit.ok || !(motion_error(task, longer) < kLinear)) return any;
    s = longer, periods = std::min(most, 2 * periods), any = true;
  }
  return any;
}

// The longest windows over which the model stays within reach of its linearisation.
double horizon(const Task& task, State& s, double from, bool massless) {
  const Model start = s.model;
  double periods = from;
  for (;; periods /= 2) {
    s.model = start;
    lay(task, periods, s);
    settle(task, s, kBaseSteps);
    const bool follows = s.fit.ok && motion_error(task, s) < kLinear;
    if (!massless && follows) widen(task, from, periods, s);
    if (massless || follows || periods / 2 < kShortestHorizon) return periods;
  }
}

}  // namespace

double motion_error(const Task& task, const State& s) {
  if (!s.fit.ok) return 1e300;
  Evaluator e(task.system, s.model, task.records);
  double worst = 0;
  for (size_t c = 0; c < e.traces(0).size(); ++c) {
    double sum = 0, count = 0;
    for (const Window& w : s.seen) {
      const auto y = e.traces(w.record)[c].y.segment(w.from, w.length).array();
      sum += (y - y.mean()).square().sum(), count += static_cast<double>(w.length);
    }
    worst = std::max(worst, std::sqrt(s.fit.mean_square[static_cast<Index>(c)] / std::max(1e-300, sum / count)));
  }
  return worst;
}

double missed_percent(const Task& task, const State& state) {
  double worst = 0;
  for (double percent : score_unseen(task, state).nrmse_percent) worst = std::max(worst, percent);
  return worst;
}

bool right(const Task& task, const Choice& choice) {
  return choice.base.fit.ok && missed_percent(task, choice.base) < kRight_percent;
}

bool near_enough(const Task& task, const Choice& choice) {
  return choice.base.fit.ok && noise_share(choice.base_left, choice.base.fit) < kMostlyNoise &&
         missed_percent(task, choice.base) < kNearEnough_percent;
}

Choice rig_fitted(const Task& task) {
  Choice choice;
  State now;
  now.model = rig_as_given(task.system, task.records);
  start_values(task.system, task.records, now.model);
  const bool massless = Evaluator(task.system, now.model, task.records).massless();
  choice.periods = horizon(task, now, longest_horizon(task.records), massless);
  choice.base = choice.final = now;
  choice.base_fits_nothing = !massless && !(motion_error(task, now) < kLinear);
  if (now.fit.ok) choice.base_left = choice.final_left = left_by(task.system, task.records, now);
  return choice;
}

void choose(const Task& task, Choice& choice, const std::function<void(double)>& progress) {
  State now = choice.final;
  if (!now.fit.ok || now.unseen.empty() || near_enough(task, choice)) return;
  bool warmed = false;
  while (choice.named.size() < kMostCauses) {
    const Left remains = left_by(task.system, task.records, now);
    const double noise = noise_share(remains, now.fit);
    const State part = part_of(task, now, noise);
    Round round = round_of(task, part, choice.named.size(), remains, noise, choice);
    if (!warmed) {
      const Attempt warm = warming(task, part, noise);
      if (warm.state.fit.ok && (!round.found || whole_error(warm) < kTogether * whole_error(round.best)))
        round.best = warm, round.found = warmed = true;
    }
    if (!round.found) break;
    const double left = error_over(now.fit, choice.base.fit);
    if (!choice.named.empty() && left * (1 - round.best.error) < kFurtherShare * (1 - left)) break;
    for (Candidate c : round.best.candidates) {
      keep_shape(round.best.state.model, c);
      choice.named.push_back(Named{c, round.best.z, share_of(round.best, noise), {}});
    }
    now = on_all(task, now, round.best.state.model);
    progress(static_cast<double>(choice.named.size()) / static_cast<double>(kMostCauses));
  }
  choice.final = now;
  weigh_rivals(task, progress, choice);
  choice.final_left = left_by(task.system, task.records, choice.final);
}

void adopt(const Task& task, const std::vector<Candidate>& found, const std::vector<double>& values, Choice& choice) {
  std::vector<std::vector<double>> starts;
  for (double v : values) starts.push_back({v});
  Attempt t = attempt(task, choice.base, found, starts, kBaseSteps);
  if (!t.state.fit.ok) return;
  for (const Candidate& c : found) {
    choice.named.push_back(Named{c, t.z, share_of(t, noise_share(choice.base_left, choice.base.fit)), {}});
  }
  choice.final = t.state;
}

bool borne_out(const Task& task, const State& base, const std::vector<Candidate>& found,
               const std::vector<double>& values, State* fitted) {
  std::vector<std::vector<double>> starts;
  for (double v : values) starts.push_back({v});
  const Attempt all = attempt(task, base, found, starts, kTrialSteps);
  if (fitted) *fitted = all.state;
  if (!all.state.fit.ok || !(all.z > kBorneOut) || !unseen_agrees(all)) return false;
  for (size_t i = 0; found.size() > 1 && i < found.size(); ++i) {
    std::vector<Candidate> fewer = found;
    std::vector<std::vector<double>> start = starts;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i)),
        start.erase(start.begin() + static_cast<std::ptrdiff_t>(i));
    if (attempt(task, base, fewer, start, kTrialSteps).unseen <= all.unseen) return false;
  }
  return true;
}

}  // namespace diagnosis::runs

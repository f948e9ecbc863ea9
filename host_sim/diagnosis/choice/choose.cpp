#include <algorithm>
#include <cmath>

#include "../fit/start.hpp"
#include "choice.hpp"

namespace diagnosis::runs {
namespace {

// A normal deviate that chance passes on one of 200 candidates once in 500 records, with a margin for what is not normal.
constexpr double kSignificant = 4.5;
// The same where most of the residual is not noise: there the share of it and unseen data decide, and chance is no rival.
constexpr double kPlain = 3;
constexpr double kMostlyNoise = 0.5;
constexpr double kNoiseAlone = 0.8;
constexpr double kWorthFitting = 2;
// Of what is still to be explained, that a cause has to take.
constexpr double kShare = 0.3;
constexpr size_t kMostCauses = 4;
constexpr size_t kShortList = 5, kPairs = 40, kPairTrials = 2;
constexpr double kLinear = 0.25;          // error over motion up to which a linearisation is trusted
constexpr double kShortestHorizon = 0.2;  // periods
constexpr int kBaseSteps = 12, kTrialSteps = 6;
constexpr double kAsWell = 1.1;  // of the squared error: so near, the simpler is named
constexpr double kClear = 2;     // of a difference, paired over windows, in standard errors

void lay(const Task& task, double periods, State& s) {
  const bool apart = task.training < task.records.size();
  s.seen.clear(), s.unseen.clear();
  for (Window& w : lay_windows(task.records, periods, apart ? 0 : 0.3)) {
    const bool unseen = apart ? w.record >= task.training : w.unseen;
    (unseen ? s.unseen : s.seen).push_back(w);
  }
}

void settle(const Task& task, State& s, int steps) {
  s.fit = fit(task.system, task.records, s.model, s.seen, steps);
  if (!s.fit.ok) return;
  Model frozen = s.model;
  s.unseen_fit = fit(task.system, task.records, frozen, s.unseen, steps, true);
}

// The longest windows over which the model stays within reach of its linearisation.
double horizon(const Task& task, State& s, double from, bool massless) {
  const Model start = s.model;
  double periods = from;
  for (;; periods /= 2) {
    s.model = start;
    lay(task, periods, s);
    settle(task, s, kBaseSteps);
    if (massless || (s.fit.ok && motion_error(task, s) < kLinear) || periods / 2 < kShortestHorizon) return periods;
  }
}

struct Trial {
  std::vector<Candidate> candidates;
  State state;
  double error = 1e300, unseen = 1e300, z = 0;
  int complexity = 0;
};

double least_z(const Trial& t, size_t added_from) {
  const std::vector<Determined> d = determined(t.state.fit, t.state.model);
  const std::vector<Parameter> p = parameters_of(t.state.model);
  double least = 1e300;
  for (size_t i = 0; i < p.size(); ++i)
    if (p[i].term >= added_from && !p[i].shape) least = std::min(least, std::abs(d[i].z));
  return least;
}

// A term that acts in another's place has no coefficient of its own: what it brings, block by block.
double paired_z(const Fitted& before, const Fitted& after) {
  const size_t n = std::min(before.window_ss.size(), after.window_ss.size());
  double sum = 0, square = 0;
  for (size_t w = 0; w < n; ++w) {
    const double d = (before.window_ss[w] - after.window_ss[w]).cwiseQuotient(before.mean_square).sum();
    sum += d, square += d * d;
  }
  const double mean = sum / static_cast<double>(n);
  const double variance = (square / static_cast<double>(n) - mean * mean) / std::max(1.0, static_cast<double>(n) - 1);
  return normal_deviate(mean / std::sqrt(variance + 1e-300), std::max(1.0, static_cast<double>(n) - 1));
}

Trial try_out(const Task& task, const State& now, const std::vector<Candidate>& candidates,
              const std::vector<std::vector<double>>& values, int steps) {
  Trial t;
  t.candidates = candidates;
  t.state.model = now.model, t.state.seen = now.seen, t.state.unseen = now.unseen;
  bool hosted = false;
  for (size_t i = 0; i < candidates.size(); ++i) {
    t.state.model = joined(t.state.model, candidates[i], values[i]);
    t.complexity += candidates[i].complexity, hosted = hosted || candidates[i].host >= 0;
  }
  settle(task, t.state, steps);
  t.error = error_over(t.state.fit, now.fit), t.unseen = error_over(t.state.unseen_fit, now.unseen_fit);
  if (t.state.fit.ok) {
    t.z = std::min(1e300, least_z(t, now.model.size()));
    if (hosted) t.z = std::min(t.z, paired_z(now.fit, t.state.fit));
  }
  return t;
}

// Share of what is not noise that a trial takes.
double share_of(const Trial& t, double noise) { return (1 - t.error) / std::max(1e-12, 1 - std::min(noise, t.error)); }

// On all windows, the unseen ones with their share.
double whole_error(const Trial& t) {
  const double seen = static_cast<double>(t.state.seen.size()), unseen = static_cast<double>(t.state.unseen.size());
  return (seen * t.error + unseen * t.unseen) / (seen + unseen);
}

bool passes(const Trial& t, size_t already, double noise) {
  const double n = static_cast<double>(already + t.candidates.size());
  const bool plain = noise < kMostlyNoise && 1 - t.unseen > 0.5 * (1 - t.error);
  return t.z > (plain ? kPlain : kSignificant * std::sqrt(n)) && share_of(t, noise) > 1 - std::pow(1 - kShare, n) &&
         t.unseen < 1;
}

// Over seen and unseen windows: how clearly the second leaves less than the first.
double paired_over_all(const Trial& a, const Trial& b) {
  Fitted x = a.state.fit, y = b.state.fit;
  for (const Vec& v : a.state.unseen_fit.window_ss) x.window_ss.push_back(v);
  for (const Vec& v : b.state.unseen_fit.window_ss) y.window_ss.push_back(v);
  return paired_z(x, y);
}

// Whether one trial is clearly better than another, over windows taken in pairs, or leaves much less.
bool clearly_better(const Trial& a, const Trial& b, double noise) {
  const double over = whole_error(b) - whole_error(a),
               left = std::max(1e-12, whole_error(a) - std::min(noise, whole_error(a)));
  if (paired_over_all(b, a) > kClear) return true;
  return over > left;
}

struct Round {
  Trial best;
  std::vector<Trial> rivals;
  double noise = 0;
  bool found = false;
};

Round round_of(const Task& task, const State& now, size_t already, Choice& choice) {
  Round round;
  const Left left = left_by(task.system, task.records, now);
  round.noise = noise_share(left, now.fit);
  choice.last_candidates = candidates_beside(task.system, now.model, task.records);
  choice.last_screen = screen(task.system, task.records, now.model, now.seen, now.fit, choice.last_candidates, kPairs);
  const Screen& s = choice.last_screen;
  std::vector<Trial> singles;
  for (const Screened& one : s.singles) {
    if (singles.size() >= kShortList) break;
    if (one.z < (round.noise < kMostlyNoise ? kWorthFitting : kPlain) * std::sqrt(static_cast<double>(already + 1)))
      continue;
    singles.push_back(try_out(task, now, {choice.last_candidates[one.candidate]}, {one.value}, kTrialSteps));
    if (round.noise > kNoiseAlone)
      singles.back().z = std::max(singles.back().z, one.z);  // finer blocks: they are independent
  }
  std::sort(singles.begin(), singles.end(),
            [](const Trial& a, const Trial& b) { return whole_error(a) < whole_error(b); });
  const auto first =
      std::find_if(singles.begin(), singles.end(), [&](const Trial& t) { return passes(t, already, round.noise); });
  if (first != singles.end()) round.best = *first, round.found = true;
  // two that help only together: where no single does, or where they leave half of what the best single with its best partner does
  double with_best = 0;
  for (const ScreenedPair& p : s.pairs)
    for (size_t c : {p.first, p.second})
      if (round.found && choice.last_candidates[c].same_place(round.best.candidates[0]))
        with_best = std::max(with_best, p.gain);
  std::vector<Trial> pairs;
  for (const ScreenedPair& p : s.pairs) {
    if (pairs.size() >= kPairTrials || already + 2 > kMostCauses) break;
    if (round.found && 1 - p.gain > 0.5 * (1 - with_best)) break;
    const std::vector<Candidate> both = {choice.last_candidates[p.first], choice.last_candidates[p.second]};
    pairs.push_back(try_out(task, now, both, {{0.0}, {0.0}}, 2 * kTrialSteps));
  }
  for (const Trial& t : pairs)
    if (passes(t, already, round.noise) && (!round.found || whole_error(t) < 0.5 * whole_error(round.best)))
      round.best = t, round.found = true;
  if (!round.found) return round;
  if (round.best.candidates.size() == 1)
    for (const Trial& t : singles)
      if (!t.candidates[0].same_place(round.best.candidates[0]) && t.z > kPlain && t.unseen < 1 &&
          !clearly_better(round.best, t, round.noise))
        round.rivals.push_back(t);
  return round;
}

// The simplest of those that do equally well is named.
void name_simplest(Round& round) {
  for (Trial& t : round.rivals)
    if (t.complexity < round.best.complexity && whole_error(t) < kAsWell * whole_error(round.best))
      std::swap(t, round.best);
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

double noise_share(const Left& left, const Fitted& fit) {
  return left.noise.size() ? left.noise.cwiseQuotient(fit.mean_square).cwiseMin(1.0).mean() : 0;
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
  if (!now.fit.ok || now.unseen.empty()) return;
  while (choice.named.size() < kMostCauses) {
    Round round = round_of(task, now, choice.named.size(), choice);
    if (!round.found) break;
    name_simplest(round);
    for (const Candidate& c : round.best.candidates) {
      choice.named.push_back(Named{c, round.best.z, share_of(round.best, round.noise), {}});
      for (const Trial& t : round.rivals)
        choice.named.back().rivals.push_back(Rival{t.candidates[0], t.error / round.best.error});
    }
    now = round.best.state;
    settle(task, now, kBaseSteps);
    progress(static_cast<double>(choice.named.size()) / static_cast<double>(kMostCauses));
  }
  choice.final = now;
  choice.final_left = left_by(task.system, task.records, now);
}

void adopt(const Task& task, const std::vector<Candidate>& found, const std::vector<double>& values, Choice& choice) {
  std::vector<std::vector<double>> starts;
  for (double v : values) starts.push_back({v});
  Trial t = try_out(task, choice.base, found, starts, kBaseSteps);
  if (!t.state.fit.ok) return;
  for (const Candidate& c : found) {
    choice.named.push_back(Named{c, t.z, share_of(t, noise_share(choice.base_left, choice.base.fit)), {}});
  }
  choice.final = t.state;
}

bool borne_out(const Task& task, const State& base, const std::vector<Candidate>& found,
               const std::vector<double>& values) {
  std::vector<std::vector<double>> starts;
  for (double v : values) starts.push_back({v});
  const Trial all = try_out(task, base, found, starts, kTrialSteps);
  if (!all.state.fit.ok || !(all.z > kPlain) || !(all.unseen < 1)) return false;
  for (size_t i = 0; found.size() > 1 && i < found.size(); ++i) {
    std::vector<Candidate> fewer = found;
    std::vector<std::vector<double>> start = starts;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i)),
        start.erase(start.begin() + static_cast<std::ptrdiff_t>(i));
    if (try_out(task, base, fewer, start, kTrialSteps).unseen <= all.unseen) return false;
  }
  return true;
}

}  // namespace diagnosis::runs

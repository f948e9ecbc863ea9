#include "horizon.hpp"

#include <algorithm>
#include <cmath>

#include "attempt.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kShortestHorizon = 0.2;  // periods
constexpr double kNoGain = 0.98;          // of an error, that a fit which is settled leaves at least
constexpr double kEnough = 20000;         // samples: some hundred periods tell one valley from another

void thin_out(std::vector<Window>& windows, size_t every) {
  size_t kept = 0;
  for (size_t i = 0; i < windows.size(); i += every) windows[kept++] = windows[i];
  windows.resize(kept);
}

}  // namespace

void lay(const Task& task, double periods, State& s, double most) {
  const bool apart = task.training < task.records.size();
  s.seen.clear(), s.unseen.clear();
  double rows = 0;
  for (Window& w : lay_windows(task.records, periods, apart ? 0 : 0.3, massless(s.model))) {
    const bool unseen = apart ? w.record >= task.training : w.unseen;
    (unseen ? s.unseen : s.seen).push_back(w), rows += unseen ? 0 : static_cast<double>(w.length);
  }
  const size_t every = std::min(static_cast<size_t>(1 + rows / most), s.seen.size() / (2 * kEnoughWindows));
  if (every > 1) thin_out(s.seen, every), thin_out(s.unseen, every);
}

namespace {

// The fitted windows alone; the unseen ones are asked once the windows have their length.
void settle_seen(const Task& task, State& s) { s.fit = fit(task.system, task.records, s.model, s.seen, kBaseSteps); }

}  // namespace

void settle_unseen(const Task& task, State& s) {
  Model frozen = s.model;
  if (s.fit.ok) s.unseen_fit = fit(task.system, task.records, frozen, s.unseen, kBaseSteps, true);
}

Choice over_windows(const Task& task, const Choice& choice, double periods) {
  Choice over = choice;
  over.periods = periods;
  lay(task, periods, over.base);
  settle(task, over.base, kBaseSteps);
  over.final = over.base;
  return over;
}

bool widen(const Task& task, double longest, double& periods, State& s, double most) {
  bool any = false;
  while (periods < 0.75 * longest) {
    State longer = s;
    lay(task, std::min(longest, 2 * periods), longer, most);
    if (longer.unseen.empty() != s.unseen.empty()) return any;
    settle_seen(task, longer);
    if (!follows(task, longer)) return any;
    s = longer, periods = std::min(longest, 2 * periods), any = true;
  }
  return any;
}

namespace {

// Of the fastest of the motions between two DOFs, over that of the slowest DOF: what turns freely is slow, its shafts are not.
double quickest_share(const Task& task) {
  double share = 1;
  for (const Prepared& p : task.records)
    for (size_t l = 0; l < task.system.known_links; ++l) {
      const rig_file::Link& link = task.system.links[l];
      if (link.a < 1 || link.b < 1) continue;
      const Guess &a = p.guess[static_cast<size_t>(link.a - 1)], &b = p.guess[static_cast<size_t>(link.b - 1)];
      const double rate = rms_about_mean(a.v - b.v), way = rms_about_mean(a.x - b.x);
      if (rate > 0 && p.period_s > 0) share = std::min(share, 6.283185307179586 * way / rate / p.period_s);
    }
  return share;
}

// A long window's error has valleys beside the lowest, friction's most of all. A fit over shorter windows, carried on to the long
// ones, finds the lower one more often; nothing is lost where it does not.
void from_shorter(const Task& task, const Model& start, double periods, State& s) {
  if (motion_error(task, s) < kSmall) return;
  State other = s, same = s;
  other.model = start;
  double reached = periods / kShorter;
  lay(task, reached, other, kEnough);
  settle_seen(task, other);
  if (!follows(task, other)) return;
  widen(task, periods, reached, other, kEnough);
  if (reached != periods || !other.fit.ok) return;
  const bool some = other.seen.size() < s.seen.size();
  if (some) same.seen = other.seen, same.unseen = other.unseen, settle_seen(task, same);
  if (same.fit.ok && error_over(other.fit, same.fit) >= 1) return;
  if (some) {
    lay(task, periods, other);
    settle_seen(task, other);
    if (!other.fit.ok || error_over(other.fit, s.fit) >= 1) return;
  }
  s = other;
}

}  // namespace

constexpr int kMostRefits = 5;  // of what no windows follow: each goes on where the one before ended its steps

// Where no windows are followed short ones are no better: their own states follow anything. Of the models that were found, the
// one that leaves the least over windows that tell is gone on from, if it is in phase there. 0: it is not.
double best_over_windows_that_tell(const Task& task, const std::vector<Model>& found, double from, State& s) {
  const double periods = std::min(from, kLeastPeriods);
  State best;
  for (const Model& model : found) {
    State other;
    other.model = model;
    lay(task, periods, other, kEnough);
    Model frozen = model;
    other.fit = fit(task.system, task.records, frozen, other.seen, kTrialSteps, true);
    if (other.fit.ok && (!best.fit.ok || error_over(other.fit, best.fit) < 1)) best = other;
  }
  if (!best.fit.ok) return 0;
  lay(task, periods, best);
  settle_seen(task, best);
  for (int i = 0; i < kMostRefits && best.fit.ok; ++i) {
    State on = best;
    settle_seen(task, on);
    if (!on.fit.ok || !(error_over(on.fit, best.fit) < 1)) break;
    const bool settled = error_over(on.fit, best.fit) > kNoGain;
    best = on;
    if (settled) break;
  }
  if (!(motion_error(task, best, false) < kInPhase)) return 0;
  s = best;
  return periods;
}

// The longest windows over which the model stays within reach of its linearisation. What no shorter windows follow either of the
// motions between two DOFs, though the DOFs are followed, is noise of a colour that third differences do not show.
double horizon(const Task& task, State& s, double from, bool massless) {
  const Model start = s.model;
  State longest;
  std::vector<Model> found;
  double followed = 0;
  const double shortest = kShortestHorizon * quickest_share(task);
  double periods = from;
  for (;; periods /= 2) {
    s.model = start;
    lay(task, periods, s);
    settle_seen(task, s);
    const bool near = follows(task, s);
    if (!massless && near && periods == from) from_shorter(task, start, periods, s);
    if (!massless && near) widen(task, from, periods, s);
    if (massless || near) return periods;
    if (motion_error(task, s, false) < 1) found.push_back(s.model);  // nearer than no motion at all
    if (followed == 0 && follows(task, s, false)) longest = s, followed = periods;
    if (periods / 2 >= shortest) continue;
    if (followed > 0) s = longest, periods = followed;
    const double told = followed > 0 ? 0 : best_over_windows_that_tell(task, found, from, s);
    return told > 0 ? told : periods;
  }
}

namespace {

// What windows add up to: of a channel, or of the difference of two.
struct MotionSums {
  double error = 0, missed = 0, motion = 0, noise = 0, count = 0, third_differences = 0;
  void add(const Vec& y, const Vec& residual) { add((y.array() - y.mean()).square().sum(), residual); }
  void add(double motion_square, const Vec& residual) {
    error += residual.squaredNorm(), missed += residual.sum(), motion += motion_square;
    count += static_cast<double>(residual.size());
    noise += white_noise_sum(residual),
        third_differences += static_cast<double>(std::max<Index>(0, residual.size() - 3));
  }
  double about_mean() const { return error - missed * missed / std::max(1.0, count); }
  double noise_sum() const { return third_differences > 0 ? noise / third_differences * count : 0; }
};

// The two channels of one quantity at the ends of a link, -1 where there are none.
std::pair<int, int> channels_across(const rig_file::Link& l, const std::vector<MotionTrace>& traces, int quantity) {
  std::pair<int, int> found{-1, -1};
  for (size_t c = 0; c < traces.size(); ++c) {
    if (traces[c].quantity != quantity) continue;
    if (traces[c].dof + 1 == l.a) found.first = static_cast<int>(c);
    if (traces[c].dof + 1 == l.b) found.second = static_cast<int>(c);
  }
  return found.first < 0 || found.second < 0 ? std::make_pair(-1, -1) : found;
}

// of: what of the error's square counts.
template <typename Of>
double error_over_motion(const Task& task, const State& s, bool links_too, Of of) {
  if (!s.fit.ok) return 1e300;
  Evaluator e(task.system, s.model, task.records);
  const std::vector<MotionTrace>& traces = e.traces(0);
  std::vector<std::pair<int, int>> across;  // links between DOFs: masses that turn together hide what their shaft does
  for (size_t l = 0; l < task.system.known_links && !e.massless() && links_too; ++l)
    for (int q = 0; q < 3; ++q) {
      const auto ends = channels_across(task.system.links[l], traces, q);
      if (ends.first >= 0) across.push_back(ends);
    }
  std::vector<MotionSums> own(traces.size()), relative(across.size());
  WindowRun run;
  for (const Window& w : s.seen) {
    if (!e.run(w, false, false, run)) return 1e300;
    const auto y = [&](int c) { return e.traces(w.record)[static_cast<size_t>(c)].y.segment(w.from, w.length); };
    const auto r = [&](int c) { return run.residual.segment(c * w.length, w.length); };
    for (size_t c = 0; c < traces.size(); ++c)
      own[c].add(motion_square(task.records[w.record], e.traces(w.record)[c], w.from, w.length),
                 r(static_cast<int>(c)));
    for (size_t i = 0; i < across.size(); ++i)
      relative[i].add(Vec(y(across[i].first) - y(across[i].second)), r(across[i].first) - r(across[i].second));
  }
  double worst = 0;
  for (size_t c = 0; c < own.size(); ++c) {
    const double rounding = traces[c].rounding_variance() * own[c].count, motion = own[c].motion - rounding;
    if (motion < kShown * rounding) continue;  // a DOF that rests, but for a step of its encoder: nothing to follow
    worst = std::max(worst, std::sqrt(std::max(0.0, of(own[c]) - rounding) / std::max(1e-300, motion)));
  }
  for (const MotionSums& m : relative) {
    const double noise = m.noise_sum(), motion = m.motion - noise;
    if (motion > kShown * noise) worst = std::max(worst, std::sqrt(std::max(0.0, of(m) - noise) / motion));
  }
  return worst;
}

}  // namespace

double motion_error(const Task& task, const State& s, bool links_too) {
  return error_over_motion(task, s, links_too, [](const MotionSums& m) { return m.error; });
}

bool follows(const Task& task, const State& s, bool links_too) {
  return error_over_motion(task, s, links_too, [](const MotionSums& m) { return m.about_mean(); }) < kFollows;
}

}  // namespace diagnosis::runs

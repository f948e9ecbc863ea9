#include "horizon.hpp"

#include <algorithm>
#include <cmath>

#include "../first_values/mode_scan.hpp"
#include "../trial/settle.hpp"

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

constexpr int kMostRefits = 5;  // of what no windows follow: each goes on where the one before ended its steps

// Where no windows are followed short ones are no better: from their own states an endless mass follows any ringing. Of the models that
// were found, and of what the balance of forces over frequency says, the one that leaves the least over the longest windows is
// gone on from there. False: it is not in phase.
bool best_over_longest(const Task& task, std::vector<Model> found, double longest, State& s) {
  if (const auto balanced = balanced_numbers(task.system, task.records, s.model)) found.push_back(*balanced);
  State best;
  for (const Model& model : found) {
    State other;
    other.model = model;
    lay(task, longest, other, kEnough);
    Model frozen = model;
    other.fit = fit(task.system, task.records, frozen, other.seen, kTrialSteps, true);
    if (other.fit.ok && (!best.fit.ok || error_over(other.fit, best.fit) < 1)) best = other;
  }
  if (!best.fit.ok) return false;
  lay(task, longest, best);
  settle_seen(task, best);
  for (int i = 0; i < kMostRefits && best.fit.ok; ++i) {
    State on = best;
    settle_seen(task, on);
    if (!on.fit.ok || !(error_over(on.fit, best.fit) < 1)) break;
    const bool settled = error_over(on.fit, best.fit) > kNoGain;
    best = on;
    if (settled) break;
  }
  if (!(motion_error(task, best, false) < kInPhase)) return false;
  s = best;
  return true;
}

}  // namespace

// The longest windows over which the model stays within reach of its linearisation. What no shorter windows follow either of the
// motions between two DOFs, though the DOFs are followed, is noise of a colour that third differences do not show.
double horizon(const Task& task, State& s, double from, bool massless) {
  const Model start = s.model;
  State longest;
  std::vector<Model> found;
  double followed = 0;
  const double shortest = kShortestHorizon * quickest_share(task);
  if (!std::isfinite(from)) throw CannotAnswer("nothing moves in the records");
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
    return followed == 0 && best_over_longest(task, found, from, s) ? from : periods;
  }
}

// Noise and steps of a channel make a short window's start, and the window misses what that moves; over a long one the motion outweighs
// them. The windows' lengths go up to all that is seen; those that are followed are the longest.
bool over_longer(const Task& task, const Model& start, double& periods, State& s) {
  double whole = 0;
  for (const Prepared& p : task.records)
    whole = std::max(whole, static_cast<double>(p.samples) * p.step_s / p.period_s);
  if (longest_horizon(task.records) >= whole) return false;
  std::vector<Model> starts{start};
  if (const auto balanced = balanced_numbers(task.system, task.records, start)) starts.push_back(*balanced);
  for (double longer = std::min(whole, 2 * longest_horizon(task.records));; longer = std::min(whole, 2 * longer)) {
    for (const Model& model : starts) {
      State other;
      other.model = model;
      lay(task, longer, other, kEnough);
      settle_seen(task, other);
      if (other.unseen.empty() != s.unseen.empty() || !follows(task, other, false)) continue;
      periods = longer, s = other;
      widen(task, whole, periods, s);
      return true;
    }
    if (longer >= whole) return false;
  }
}

}  // namespace diagnosis::runs

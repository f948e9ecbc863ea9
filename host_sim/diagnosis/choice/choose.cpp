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
constexpr double kShortestHorizon = 0.2;  // periods
constexpr double kShorter = 4;            // times: where valleys of a window's error are as much wider
constexpr double kPlainlyRight = 0.02;    // of the motion: no other valley is as low
constexpr double kNearEnough_percent =
    0.3;                                 // of the motion, free run on unseen data: sensors are not better calibrated
constexpr double kRight_percent = 0.05;  // where noise may hide a cause: no sensor tells it from the truth

constexpr double kAll = 1e300;     // samples
constexpr double kEnough = 20000;  // samples: some hundred periods tell one valley from another

void thin_out(std::vector<Window>& windows, size_t every) {
  size_t kept = 0;
  for (size_t i = 0; i < windows.size(); i += every) windows[kept++] = windows[i];
  windows.resize(kept);
}

// Lays windows of so many periods over the records; every second, third ... of them where they hold more samples than
// `most`.
void lay(const Task& task, double periods, State& s, double most = kAll) {
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

// The fitted windows alone; the unseen ones are asked once the windows have their length.
void settle_seen(const Task& task, State& s) { s.fit = fit(task.system, task.records, s.model, s.seen, kBaseSteps); }
void settle_unseen(const Task& task, State& s) {
  Model frozen = s.model;
  if (s.fit.ok) s.unseen_fit = fit(task.system, task.records, frozen, s.unseen, kBaseSteps, true);
}

// Windows twice as long, up to `longest` periods, as long as the fitted model follows them: what was fitted over short
// ones starts nearer than first values do. True where any were longer.
bool widen(const Task& task, double longest, double& periods, State& s, double most = kAll) {
  bool any = false;
  while (periods < 0.75 * longest) {
    State longer = s;
    lay(task, std::min(longest, 2 * periods), longer, most);
    if (longer.unseen.empty() != s.unseen.empty()) return any;
    settle_seen(task, longer);
    if (!longer.fit.ok || !(motion_error(task, longer) < kFollows)) return any;
    s = longer, periods = std::min(longest, 2 * periods), any = true;
  }
  return any;
}

// Of the fastest of the motions between two DOFs, over that of the slowest DOF: what turns freely is slow, its shafts
// are not.
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

// A long window's error has valleys beside the lowest, friction's most of all. A fit over shorter windows, carried on
// to the long ones, finds the lower one more often; nothing is lost where it does not.
void from_shorter(const Task& task, const Model& start, double periods, State& s) {
  if (motion_error(task, s) < kPlainlyRight) return;
  State other = s, same = s;
  other.model = start;
  double reached = periods / kShorter;
  lay(task, reached, other, kEnough);
  settle_seen(task, other);
  if (!other.fit.ok || !(motion_error(task, other) < kFollows)) return;
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

// The longest windows over which the model stays within reach of its linearisation. What no shorter windows follow
// either of the motions between two DOFs, though the DOFs are followed, is noise of a colour that third differences
// do not show.
double horizon(const Task& task, State& s, double from, bool massless) {
  const Model start = s.model;
  State longest;
  double followed = 0;
  const double shortest = kShortestHorizon * quickest_share(task);
  double periods = from;
  for (;; periods /= 2) {
    s.model = start;
    lay(task, periods, s);
    settle_seen(task, s);
    const bool follows = s.fit.ok && motion_error(task, s) < kFollows;
    if (!massless && follows && periods == from) from_shorter(task, start, periods, s);
    if (!massless && follows) widen(task, from, periods, s);
    if (massless || follows) return periods;
    if (s.fit.ok && followed == 0 && motion_error(task, s, false) < kFollows) longest = s, followed = periods;
    if (periods / 2 >= shortest) continue;
    if (followed > 0) s = longest, periods = followed;
    return periods;
  }
}

// What windows add up to: of a channel, or of the difference of two.
struct MotionSums {
  double error = 0, motion = 0, noise = 0, count = 0, third_differences = 0;
  void add(const Vec& y, const Vec& residual) {
    error += residual.squaredNorm(), motion += (y.array() - y.mean()).square().sum();
    count += static_cast<double>(y.size());
    noise += white_noise_sum(residual),
        third_differences += static_cast<double>(std::max<Index>(0, residual.size() - 3));
  }
  double noise_sum() const { return third_differences > 0 ? noise / third_differences * count : 0; }
};

// Motion of a link that a sensor shows: twice its noise.
constexpr double kShown = 4;

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

}  // namespace

double motion_error(const Task& task, const State& s, bool links_too) {
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
    for (size_t c = 0; c < traces.size(); ++c) own[c].add(y(static_cast<int>(c)), r(static_cast<int>(c)));
    for (size_t i = 0; i < across.size(); ++i)
      relative[i].add(y(across[i].first) - y(across[i].second), r(across[i].first) - r(across[i].second));
  }
  double worst = 0;
  for (const MotionSums& m : own) worst = std::max(worst, std::sqrt(m.error / std::max(1e-300, m.motion)));
  for (const MotionSums& m : relative) {
    const double noise = m.noise_sum(), motion = m.motion - noise;
    if (motion > kShown * noise) worst = std::max(worst, std::sqrt(std::max(0.0, m.error - noise) / motion));
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
  if (!choice.base.fit.ok) return false;
  return motion_error(task, choice.base) < kAsGoodAsRight ||
         (noise_share(choice.base_left, choice.base.fit) < kMostlyNoise &&
          missed_percent(task, choice.base) < kNearEnough_percent);
}

Choice rig_fitted(const Task& task) {
  Choice choice;
  State now;
  now.model = rig_as_given(task.system, task.records);
  start_values(task.system, task.records, now.model);
  choice.periods = horizon(task, now, longest_horizon(task.records), massless(now.model));
  settle_unseen(task, now);
  choice.base = choice.final = now;
  choice.base_fits_nothing = !massless(now.model) && !(motion_error(task, now, false) < kFollows);
  if (now.fit.ok) choice.base_left = choice.final_left = left_by(task.system, task.records, now);
  return choice;
}

namespace {

constexpr double kByChance = 2;  // of a difference, paired over blocks, in standard errors

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

// Causes that the later ones have made needless: without them the windows are followed as well, as far as chance can
// tell.
void drop_needless(const Task& task, State& now, std::vector<Named>& named) {
  for (size_t i = 0; named.size() > 1 && now.fit.ok && i < named.size();) {
    if (!stands_alone(now, named[i])) {
      ++i;
      continue;
    }
    const State fewer = without(task, now, named[i]);
    if (!fewer.fit.ok || paired_z(fewer.fit, now.fit) > kByChance) {
      ++i;
      continue;
    }
    now = fewer;
    named.erase(named.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

}  // namespace

void choose(const Task& task, Choice& choice, const std::function<void(double)>& progress) {
  State now = choice.final;
  if (!now.fit.ok || now.unseen.empty() || near_enough(task, choice)) return;
  bool warmed = false;
  size_t freed = 0;
  while (choice.named.size() < kMostCauses) {
    const double left = error_over(now.fit, choice.base.fit);
    if (!choice.named.empty() && left < kFurtherShare * (1 - left)) break;  // no cause could take that much
    const Left remains = left_by(task.system, task.records, now);
    const double noise = noise_share(remains, now.fit);
    const State part = part_of(task, now, noise);
    Round round = round_of(task, part, choice.named.size(), remains, noise, choice);
    if (round.stuck) {
      now = on_all(task, now, round.unstuck.model);
      if (choice.named.empty())
        choice.base = choice.final = now, choice.base_left = left_by(task.system, task.records, now);
      if (++freed > kMostCauses) break;
      continue;
    }
    if (!warmed) {
      const Attempt warm = warming(task, part, noise);
      if (warm.state.fit.ok && (!round.found || whole_error(warm) < kTogether * whole_error(round.best)))
        round.best = warm, round.found = warmed = true;
    }
    if (!round.found) break;
    if (!choice.named.empty() && left * (1 - round.best.error) < kFurtherShare * (1 - left)) break;
    for (Candidate c : round.best.candidates) {
      keep_shape(round.best.state.model, c);
      choice.named.push_back(Named{c, round.best.z, share_of(round.best, noise), {}, round.best.shows_unseen});
    }
    now = on_all(task, now, round.best.state.model);
    progress(static_cast<double>(choice.named.size()) / static_cast<double>(kMostCauses));
  }
  drop_needless(task, now, choice.named);
  choice.final = now;
  weigh_rivals(task, progress, choice);
  choice.final_left = left_by(task.system, task.records, choice.final);
}

void adopt(const Task& task, const std::vector<Candidate>& found, const std::vector<std::vector<double>>& values,
           Choice& choice) {
  Attempt t = attempt(task, choice.base, found, values, kBaseSteps);
  if (!t.state.fit.ok || t.rounds) return;
  for (const Candidate& c : found) {
    choice.named.push_back(Named{c, t.z, share_of(t, noise_share(choice.base_left, choice.base.fit)), {}, true});
  }
  choice.final = t.state;
}

bool borne_out(const Task& task, const State& base, const std::vector<Candidate>& found,
               const std::vector<std::vector<double>>& values, State* fitted) {
  const Attempt all = attempt(task, base, found, values, kTrialSteps);
  if (fitted) *fitted = all.state;
  if (!all.state.fit.ok || all.rounds || !(all.z > kBorneOut) || !unseen_agrees(all)) return false;
  for (size_t i = 0; found.size() > 1 && i < found.size(); ++i) {
    std::vector<Candidate> fewer = found;
    std::vector<std::vector<double>> start = values;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i)),
        start.erase(start.begin() + static_cast<std::ptrdiff_t>(i));
    if (attempt(task, base, fewer, start, kTrialSteps).unseen <= all.unseen) return false;
  }
  return true;
}

}  // namespace diagnosis::runs

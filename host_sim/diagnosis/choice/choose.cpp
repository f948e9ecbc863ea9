#include <algorithm>
#include <cmath>
#include <optional>

#include "../answer/answer.hpp"
#include "../fit/start.hpp"
#include "../motion/drive_noise.hpp"
#include "hidden_mode.hpp"
#include "horizon.hpp"
#include "needless.hpp"
#include "other_shapes.hpp"
#include "possible.hpp"
#include "round.hpp"
#include "shown.hpp"
#include "warming.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kMostCauses = 4;
// Of a further number of a cause, over windows so short that what is flexible follows anything: half as much again.
constexpr double kWorthOverShort = 1.5;
constexpr double kLongDecay = 16;  // periods: an error of 1 % in a frequency is one radian at its end
constexpr double kTogether = 0.5;  // of what one cause leaves, that dampers which drift together may
constexpr double kNearEnough_percent =
    0.3;                                 // of the motion, free run on unseen data: sensors are not better calibrated
constexpr double kRight_percent = 0.05;  // where noise may hide a cause: no sensor tells it from the truth

}  // namespace

double missed_percent(const Task& task, const State& state) {
  double worst = 0;
  for (double percent : score_unseen(task, state).nrmse_percent) worst = std::max(worst, percent);
  return worst;
}

bool right(const Task& task, const Choice& choice) {
  return choice.base.fit.ok && missed_percent(task, choice.base) < kRight_percent &&
         motion_error(task, choice.base, false) < 0.01 * kNearEnough_percent;
}

bool near_enough(const Task& task, const Choice& choice) {
  if (!choice.base.fit.ok) return false;
  return motion_error(task, choice.base) < kAsGoodAsRight ||
         (noise_share(choice.base_left, choice.base.fit) < kMostlyNoise &&
          missed_percent(task, choice.base) < kNearEnough_percent);
}

namespace {

// Dry friction makes valleys of a window's error, and where the first values are poor the nearest is not the lowest. The rig without its
// unknown frictions is followed from farther away; from there they start at nought. What it follows where the rig with them
// from its own first values followed nothing is gone on from.
void from_smooth_start(const Task& task, const Model& start, State& s, double& periods) {
  const auto unknown_friction = [](const ModelTerm& t) { return t.term.kind == Kind::kCoulomb && !t.known; };
  if (massless(start) || follows(task, s) || std::none_of(start.begin(), start.end(), unknown_friction)) return;
  State smooth;
  smooth.model = start;
  for (ModelTerm& t : smooth.model)
    if (unknown_friction(t)) t.known = true, t.value = 0;
  const double reached = horizon(task, smooth, longest_horizon(task.records), false);
  for (size_t i = 0; i < start.size(); ++i) smooth.model[i].known = start[i].known;
  smooth.fit = fit(task.system, task.records, smooth.model, smooth.seen, kBaseSteps);
  if (follows(task, smooth)) s = smooth, periods = reached;
}

}  // namespace

Choice rig_fitted(const Task& task) {
  Choice choice;
  State now;
  now.model = rig_as_given(task.system, task.records);
  start_values(task.system, task.records, now.model);
  const Model start = now.model;
  choice.periods = horizon(task, now, longest_horizon(task.records), massless(now.model));
  from_smooth_start(task, start, now, choice.periods);
  if (!massless(start) && !follows(task, now, false)) over_longer(task, start, choice.periods, now);
  settle_unseen(task, now);
  choice.base = choice.final = now;
  if (now.fit.ok) choice.base_left = choice.final_left = left_by(task.system, task.records, now);
  // a noisy force shakes the simulation, though the rig file is right; one that is much noise, with what it is off on the mean
  choice.base_fits_nothing = !massless(now.model) && !follows(task, now, false) &&
                             (!now.fit.ok || (beyond_noise(choice.base_left) && !drives_are_much_noise(task.records)));
  return choice;
}

namespace {

// What stood beside the cause named last, and what left about as little as that one.
struct PassedOver {
  State beside, part;  // and the part of its windows over which they were tried
  std::vector<Candidate> candidates;
  int complexity = 0;  // of the cause that was named
};

// A cause was passed over for one that did as well, and that now wants a further one: alone it may do as well as the two (a gap
// beside a wrong spring whose misfit an end stop mends). Nothing where none does.
struct Alone {
  State state;
  Candidate candidate;
  std::vector<Candidate> outdone;  // of those passed over
};
std::optional<Alone> alone_as_good(const Task& task, const PassedOver& passed, const State& both, int further,
                                   double worth) {
  if (passed.candidates.empty()) return {};
  std::optional<Alone> best;
  std::vector<Candidate> outdone;
  for (const Candidate& candidate : passed.candidates) {
    const Attempt alone =
        attempt(task, passed.part, {candidate}, {std::vector<double>(candidate.terms.size(), 0.0)}, kBaseSteps);
    if (!alone.state.fit.ok || alone.rounds || cannot_be(task, passed.part, alone) ||
        may_be_nought(alone.state, passed.part.model.size()))
      continue;
    const State whole = on_all(task, passed.beside, alone.state);
    // a number for each cause, and its shapes
    const double may_leave = std::pow(worth, passed.complexity + further + 1 - alone.complexity);
    if (!whole.fit.ok || error_over(whole.fit, both.fit) > may_leave ||
        error_over(whole.unseen_fit, both.unseen_fit) > may_leave) {
      outdone.push_back(candidate);
      continue;
    }
    if (!best || error_over(whole.fit, best->state.fit) < 1) best = Alone{whole, candidate, {}};
  }
  if (best) keep_shape(best->state.model, best->candidate), best->outdone = outdone;
  return best;
}

// Names causes one after the other, over the windows of choice.final; worth: as in round_of().
void search(const Task& task, double worth, Choice& choice, const std::function<void(double)>& progress) {
  State now = choice.final;
  PassedOver passed;
  bool warmed = false;
  size_t freed = 0, exchanged = 0;
  const size_t most = choice.named.size() + kMostCauses;
  const double motion = motion_over_error(task, choice.base);
  while (choice.named.size() < most) {
    const double left = error_over(now.fit, choice.base.fit);
    if (!choice.named.empty() && takes_little(left, 0, motion)) break;  // no cause could take that much
    const Left remains = left_by(task.system, task.records, now);
    const double noise = noise_share(remains, now.fit);
    now.noise = remains.noise;
    const State part = part_of(task, now, noise);
    Round round = round_of(task, part, choice.named.size(), remains, noise, worth, choice);
    if (round.stuck) {
      now = on_all(task, now, round.unstuck);
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
    if (!choice.named.empty() && takes_little(left, left * round.best.error, motion)) break;
    State with = on_all(task, now, round.best.state);
    if (const auto other = from_other_shapes(task, now, round.best.candidates, with)) {
      with = other->state;
      settle(task, with, kBaseSteps);
    }
    if (all_shown(task, round.best.state.model) && !all_shown(task, with.model)) break;
    const auto alone =
        exchanged < kMostCauses ? alone_as_good(task, passed, with, round.best.complexity, worth) : std::nullopt;
    if (alone) {
      ++exchanged;
      Named& last = choice.named.back();
      last.outdone = alone->outdone, last.outdone.push_back(last.candidate), last.candidate = alone->candidate;
      now = alone->state, passed = {};
      continue;
    }
    passed = {now, part, round.passed_over, round.best.complexity};
    for (Candidate c : round.best.candidates) {
      keep_shape(round.best.state.model, c);
      choice.named.push_back(Named{c,
                                   round.best.z,
                                   share_of(round.best, noise),
                                   {},
                                   round.best.shows_unseen,
                                   false,
                                   round.best.unseen_deviations});
    }
    now = with;
    progress(static_cast<double>(choice.named.size()) / static_cast<double>(most));
  }
  drop_needless(task, choice.base, now, choice.named);
  drop_idle_damping(task, now, choice.named);
  choice.final = now;
}

// Of the long windows' squared error, seen and unseen, what a cause found over shorter ones has to take; and it has to leave less
// than what was found over the long ones.
bool holds_over_long(const State& with, const Choice& choice) {
  const auto leaves = [&](const State& beside) {
    return std::max(error_over(with.fit, beside.fit), error_over(with.unseen_fit, beside.unseen_fit));
  };
  return with.fit.ok && leaves(choice.base) < 1 - kShare && (choice.named.empty() || leaves(choice.final) < 1);
}

// A model that lacks something may follow a long window in a valley beside the right one, where no cause helps. Windows
// a quarter as long have valleys four times as wide: what they name has to help over the long ones too. The numbers are those of
// the shorter ones: what is still missing bends those of the long ones more.
void search_shorter(const Task& task, Choice& choice, const std::function<void(double)>& progress) {
  for (double periods = choice.periods / kShorter; periods >= kLeastPeriods; periods /= kShorter) {
    Choice shorter = over_windows(task, choice, periods);
    shorter.named.clear();
    if (shorter.base.unseen.empty() || !follows(task, shorter.base)) continue;
    shorter.base_left = left_by(task.system, task.records, shorter.base);
    search(task, kWorthOverShort, shorter, progress);
    if (shorter.named.empty()) continue;
    State whole = shorter.final;
    double reached = periods;
    if (widen(task, choice.periods, reached, whole)) settle_unseen(task, whole);
    if (reached < choice.periods) lay(task, choice.periods, whole), settle(task, whole, kBaseSteps);
    if (holds_over_long(whole, choice)) choice = shorter;
    return;
  }
}

// Short windows follow anything from their own states: hysteresis and what grows slowly do not show in them. Where nothing is named
// over them, windows over which the rig as given misses more are searched: what they name has to make them followed.
void search_longer(const Task& task, Choice& choice, const std::function<void(double)>& progress) {
  for (double periods = longest_horizon(task.records); periods >= kShorter * choice.periods; periods /= kShorter) {
    Choice longer = over_windows(task, choice, periods);
    if (longer.base.unseen.empty() || !(motion_error(task, longer.base) < kInPhase)) continue;
    longer.base_left = left_by(task.system, task.records, longer.base);
    search(task, kWorth, longer, progress);
    if (longer.named.empty() || !follows(task, longer.final)) continue;
    choice = longer;
    return;
  }
}

}  // namespace

void choose(const Task& task, Choice& choice, const std::function<void(double)>& progress) {
  const State& start = choice.final;
  if (!start.fit.ok || start.unseen.empty() || near_enough(task, choice)) return;
  search(task, kWorth, choice, progress);
  const bool more_left = choice.named.empty() || (choice.periods > kLongDecay &&
                                                  beyond_noise(left_by(task.system, task.records, choice.final)));
  // "unknown" is not said before windows of other lengths are searched
  const bool worth_it = beyond_noise(choice.base_left) || noise_share(choice.base_left, choice.base.fit) < kMostlyNoise;
  if (more_left && worth_it) search_shorter(task, choice, progress);
  if (choice.named.empty() && worth_it) search_longer(task, choice, progress);
  if (beyond_noise(choice.named.empty() ? choice.base_left : left_by(task.system, task.records, choice.final)) &&
      name_hidden_mode(task, choice))
    search(task, kWorth, choice, progress);
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

namespace {

// The rig's own unknown coefficients as they start where these causes are known.
Model started_beside(const Task& task, const State& base, const std::vector<Candidate>& found,
                     const std::vector<std::vector<double>>& values) {
  Model with = base.model;
  for (size_t i = 0; i < found.size(); ++i) with = joined(with, found[i], values[i]);
  for (ModelTerm& t : with) t.known = t.known || t.added;
  start_values(task.system, task.records, with);
  Model own = base.model;
  for (size_t i = 0; i < own.size(); ++i) own[i].value = with[i].value;
  return own;
}

// Causes that another test found, from its numbers. Where the rig as given does not follow its windows, its coefficients and the
// windows' states are those of another motion: from the measured one too.
Attempt attempt_of_found(const Task& task, const State& base, const std::vector<Candidate>& found,
                         const std::vector<std::vector<double>>& values) {
  Attempt carried = attempt(task, base, found, values, kTrialSteps);
  if (const auto other = from_other_shapes(task, base, found, carried.state)) carried = *other;
  if (follows(task, base)) return carried;
  State measured = base;
  measured.model = started_beside(task, base, found, values);
  Attempt afresh = attempt(task, measured, found, values, kTrialSteps, From::kMeasured);
  const bool usable = carried.state.fit.ok && !carried.rounds;
  return afresh.state.fit.ok && (!usable || whole_error(afresh) < whole_error(carried)) ? afresh : carried;
}

}  // namespace

bool borne_out(const Task& task, const State& base, const std::vector<Candidate>& found,
               const std::vector<std::vector<double>>& values, State* fitted) {
  const Attempt all = attempt_of_found(task, base, found, values);
  if (fitted) *fitted = all.state;
  if (!all.state.fit.ok || all.rounds || !(all.z > kByChance) || !unseen_agrees(all) || !matters(base, all))
    return false;
  for (size_t i = 0; found.size() > 1 && i < found.size(); ++i) {
    std::vector<Candidate> fewer = found;
    std::vector<std::vector<double>> start = values;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i)),
        start.erase(start.begin() + static_cast<std::ptrdiff_t>(i));
    if (attempt_of_found(task, base, fewer, start).unseen <= all.unseen) return false;
  }
  return true;
}

}  // namespace diagnosis::runs

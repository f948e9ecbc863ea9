#include <algorithm>
#include <cmath>

#include "../trial/merit.hpp"
#include "../valleys/hidden_mode.hpp"
#include "free_damping.hpp"
#include "horizon.hpp"
#include "in_turn.hpp"
#include "round.hpp"

namespace diagnosis::runs {
namespace {

// Of a further number of a cause, over windows so short that what is flexible follows anything: half as much again.
constexpr double kWorthOverShort = 1.5;
constexpr double kLongDecay = 16;  // periods: an error of 1 % in a frequency is one radian at its end

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
    name_in_turn(task, kWorthOverShort, shorter, progress);
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
    name_in_turn(task, kWorth, longer, progress);
    if (longer.named.empty() || !follows(task, longer.final)) continue;
    choice = longer;
    return;
  }
}

}  // namespace

void choose(const Task& task, Choice& choice, const std::function<void(double)>& progress) {
  const State& start = choice.final;
  if (!start.fit.ok || start.unseen.empty() || near_enough(task, choice)) return;
  name_in_turn(task, kWorth, choice, progress);
  const bool more_left = choice.named.empty() || (choice.periods > kLongDecay &&
                                                  beyond_noise(left_by(task.system, task.records, choice.final)));
  // "unknown" is not said before windows of other lengths are searched
  const bool worth_it = beyond_noise(choice.base_left) || noise_share(choice.base_left, choice.base.fit) < kMostlyNoise;
  if (more_left && worth_it) search_shorter(task, choice, progress);
  if (choice.named.empty() && worth_it) search_longer(task, choice, progress);
  if (beyond_noise(choice.named.empty() ? choice.base_left : left_by(task.system, task.records, choice.final)) &&
      name_hidden_mode(task, choice))
    name_in_turn(task, kWorth, choice, progress);
  weigh_rivals(task, progress, choice);
  free_damping(task, choice.final);
  choice.final_left = left_by(task.system, task.records, choice.final);
}

}  // namespace diagnosis::runs

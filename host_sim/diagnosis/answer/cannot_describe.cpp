#include "cannot_describe.hpp"

#include <algorithm>
#include <cstdio>

#include "../choice/horizon.hpp"
#include "../residual/motion_error.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kMissesAll = 0.9;  // of the motion, error: four fifths of its variance

}  // namespace

bool windows_tell(const Task& task, const Choice& choice) {
  return choice.periods >= std::min(kLeastPeriods, longest_horizon(task.records));
}

bool follows_nothing(const Task& task, const Choice& choice, const Diagnosis& d) {
  const std::vector<double>& missed = d.extended.holdout_nrmse_percent;
  if (missed.empty() || massless(choice.final.model)) return false;
  if (*std::min_element(missed.begin(), missed.end()) < 100 * kMissesAll) return false;
  return !windows_tell(task, choice) || motion_error(task, choice.final, false) > kMissesAll;
}

void say_cannot_describe(const Task& task, const Choice& choice, Diagnosis& d) {
  d.baseline.parameters.clear(), d.extended.parameters.clear();  // numbers of a model that is not this rig's
  char text[200];
  std::snprintf(
      text, sizeof text,
      "Even over %.2g of a period, each from its own best start, its simulation misses %.0f %% of the motion.",
      choice.periods, std::min(100.0, 100 * motion_error(task, choice.final)));
  d.cannot_describe = text;
  if (!beyond_noise(choice.final_left))
    d.cannot_describe += " What it misses looks like noise, and may be nothing else.";
  std::snprintf(
      text, sizeof text,
      "count the modes in the spectrum (the rig file has %zu DOF), and check the units and the channels' places",
      task.system.dofs());
  d.advice.push_back(text);
}

}  // namespace diagnosis::runs

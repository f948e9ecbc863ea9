#include "compare_unseen.hpp"

#include <algorithm>
#include <cstdio>

#include "../motion/drive_noise.hpp"
#include "../residual/motion_error.hpp"
#include "score.hpp"

namespace diagnosis::runs {
namespace {

void take(const Score& score, ModelScore& to) {
  to.holdout_nrmse_percent = score.nrmse_percent, to.holdout_mse_percent = score.mse_percent;
  to.holdout_velocity_nrmse_percent = score.velocity_percent;
}

constexpr double kMuchOfIt = 0.5;  // of what a free run misses: then nothing else needs to be wrong

// Noise of a force that is simulated drives the rig: what the run misses by that no model can mend.
void say_noise_of_drives(const Task& task, const Score& score, Diagnosis& d) {
  const bool astray = score.worst_percent > 100;  // of a model so far off nothing is noise's
  if (!d.driven || astray || score.worst_percent < kHalfOfVariance ||
      score.by_drives_percent < kMuchOfIt * score.worst_percent)
    return;
  char text[320];
  std::snprintf(text, sizeof text,
                "noise or ripple of the channel that drives the rig alone makes such a run miss %.0f %%: the intervals "
                "allow for it, %s; use the commanded force, or average repeated runs",
                score.by_drives_percent,
                drives_are_much_noise(task.records)
                    ? "and for a lasting error of that channel of an eighth of its noise"
                    : "but not for a lasting error of that channel");
  d.advice.push_back(text);
}

// A channel so coarse for the motion that its steps alone put a run as far off as one may be and still follow: what it misses by them is
// not the rig's fault.
void say_steps(const Score& score, Diagnosis& d) {
  for (size_t dof = 0; dof < score.by_steps_percent.size(); ++dof) {
    const double steps = score.by_steps_percent[dof];
    if (steps < 100 * kFollows || steps < kMuchOfIt * score.nrmse_percent[dof]) continue;
    char text[240];
    std::snprintf(text, sizeof text,
                  "the unseen motion of DOF %zu is too small for the steps of its channel: they alone make any run "
                  "miss %.0f %% of it; "
                  "record with finer steps, a larger motion, or less of its quiet end",
                  dof + 1, steps);
    d.advice.push_back(text);
  }
}

}  // namespace

double compare_unseen(const Task& task, const State& base, const State& with_causes, bool any_cause, const Vec& noise,
                      Diagnosis& d) {
  const Score before = score_unseen(task, base, &noise),
              after = any_cause ? score_unseen(task, with_causes, &noise) : before;
  take(before, d.baseline), take(after, d.extended);
  say_noise_of_drives(task, after, d);
  say_steps(after, d);
  d.gain.clear();
  for (size_t i = 0; i < before.nrmse_percent.size(); ++i) {
    const double old = before.nrmse_percent[i], now = after.nrmse_percent[i];
    d.gain.push_back(old / std::max(1e-9, now));
    d.remainder_percent.push_back(any_cause ? std::min(1000.0, 100 * now / std::max(1e-9, old)) : 100);
  }
  return after.worst_percent;
}

}  // namespace diagnosis::runs

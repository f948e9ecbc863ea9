// Whether a rig file as given is right already.
#include <algorithm>

#include "../trial/settle.hpp"
#include "../unseen/score.hpp"
#include "choice.hpp"

namespace diagnosis::runs {
namespace {

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

}  // namespace diagnosis::runs

// The error of windows' runs beside their motion.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

constexpr double kFollows =
    0.25;  // of the motion, error: up to it a linearisation is trusted and fitted states help others
constexpr double kInPhase = 0.5;  // of the motion, error: up to it a run is still in phase
// Times the variance of its noise: less motion than that a sensor does not show, and what is simulated for it cannot be judged.
constexpr double kShown = 4;
// Of the motion, of each link's too, over windows and in free runs of unseen data: calibrations of sensors are not much
// better, and where nothing in the vocabulary brings it down nobody would act on it. No other valley of the error is as low.
constexpr double kSmall = 0.02;
constexpr double kAsGoodAsRight = 1e-3;  // of the motion, over a window: no sensor of a rig is better
// Error of the windows' runs over the motion, the worst channel's; huge where there is no fit.
// links_too: of the motions between two DOFs as well.
double motion_error(const Task& task, const State& state, bool links_too = true);
// Whether windows can tell valleys apart: kFollows, but for what a channel misses all the time, which moves no phase and no shorter
// window would mend (a sensor's zero, a constant force). Where nothing drives the rig it is enough that half of the stretches are followed so: the
// loud start outweighs all others, and another mode of a blow, which dies out there, moves no phase either.
bool follows(const Task& task, const State& state, bool links_too = true);
// Squared error of a state over that of another, mean over the channels; seen or unseen windows.
double error_over(const Fitted& now, const Fitted& before);

}  // namespace diagnosis::runs

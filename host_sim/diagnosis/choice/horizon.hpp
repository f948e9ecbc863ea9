// Over how many periods of the motion a window reaches: as many as the model follows.
#pragma once
#include "choice.hpp"

namespace diagnosis::runs {

constexpr double kLeastPeriods = 1;  // of a window that tells: its start and what damps it are one less
constexpr double kShorter = 4;       // times: where valleys of a window's error are as much wider

// Lays windows of so many periods over the records, fitted ones and unseen ones; every second, third ... of them where
// they hold more samples than `most`. The model is not touched.
void lay(const Task& task, double periods, State& s, double most = 1e300);
// The states of the unseen windows, for the model fitted over the others: horizon() and widen() ask them nothing.
void settle_unseen(const Task& task, State& s);
// The rig as given fitted over windows of so many periods, whether it follows them or not: what a search over them goes on from.
// What was named stays.
Choice over_windows(const Task& task, const Choice& choice, double periods);
// Windows twice as long, up to `longest` periods, as long as the fitted model follows them: what was fitted over short
// ones starts nearer than first values do. True where any were longer.
bool widen(const Task& task, double longest, double& periods, State& s, double most = 1e300);
// The longest windows, of `from` periods at most, that the model follows, and the model fitted over them. Returns their
// periods.
double horizon(const Task& task, State& s, double from, bool massless);
// Where the model follows no windows, longer ones than horizon() begins with, from the start values. False: it follows none of them, and
// nothing is touched.
bool over_longer(const Task& task, const Model& start, double& periods, State& s);

}  // namespace diagnosis::runs

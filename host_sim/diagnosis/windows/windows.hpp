// Which stretches of the records are simulated by themselves.
#pragma once
#include "../fit/evaluator.hpp"

namespace diagnosis::runs {

struct WindowPlan {
  double periods = 8;         // length in periods of the motion
  double unseen_share = 0.3;  // of each record, its end
};

// Samples of a record until a decay has come to rest; all of one that something drives.
Index moving_samples(const Prepared& record, bool driven);
bool forced(const std::vector<Prepared>& records);
// Periods that a window has at first: more where no force keeps the motion up.
double longest_horizon(const std::vector<Prepared>& records);
// Windows over all records, those at rest left out. `unseen_share` of 0: all are for the fit.
std::vector<Window> lay_windows(const std::vector<Prepared>& records, double periods, double unseen_share);

}  // namespace diagnosis::runs

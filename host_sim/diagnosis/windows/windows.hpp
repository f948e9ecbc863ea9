// Which stretches of the records are simulated by themselves.
#pragma once
#include "../fit/evaluator.hpp"

namespace diagnosis::runs {

bool forced(const std::vector<Prepared>& records);
// Samples of a record until its motion has come to rest; all of one whose masses something drives. Without masses the
// motion is imposed and the forces answer to it: at rest friction holds any.
Index moving_samples(const Prepared& record, const std::vector<Prepared>& records, bool massless);
// Periods that a window has at first: more where no force keeps the motion up.
double longest_horizon(const std::vector<Prepared>& records);
// Windows over all records, those at rest left out. `unseen_share` of 0: all are for the fit.
std::vector<Window> lay_windows(const std::vector<Prepared>& records, double periods, double unseen_share,
                                bool massless);

}  // namespace diagnosis::runs

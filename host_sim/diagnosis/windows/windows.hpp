// Which stretches of the records are simulated by themselves.
#pragma once
#include "../fit/evaluator.hpp"

namespace diagnosis::runs {

// Samples of a record, the last one left out.
struct Span {
  Index from = 0, to = 0;
};
// From where a record is let go (from its first sample where something pushes it: `pushed`) until it has come to rest for good:
// a decay, what a blow left, a damper that is held (friction then holds any force).
Span moving_span(const Prepared& record, bool pushed);
// Whether the last share of a driven record runs on at constant speed after what moved it: what is missed there is noise over noise.
bool ends_steadily(const Prepared& record, bool pushed, double unseen_share);
// Of the records' periods, those that are not at rest.
double moving_share(const std::vector<Prepared>& records);
bool forced(const std::vector<Prepared>& records);
// Periods that a window has at first: more where no force keeps the motion up.
double longest_horizon(const std::vector<Prepared>& records);
// Windows over all records, those at rest left out. `unseen_share` of 0: all are for the fit.
std::vector<Window> lay_windows(const std::vector<Prepared>& records, double periods, double unseen_share,
                                bool massless);

}  // namespace diagnosis::runs

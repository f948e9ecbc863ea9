// Motion channels behind an anti-alias filter that the forces do not pass.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Records whose forces have passed what their motion has: a Butterworth low-pass of fourth order, the usual one.
std::vector<host_sim::Record> forces_behind(std::vector<host_sim::Record> records, double corner_Hz);

// The corner with which the rig as given simulates unseen data best; lag_s: of all motion channels. 0: there is none below half the rate.
double corner_of_motion_Hz(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                           const std::vector<host_sim::Record>& holdout, double lag_s);

// Of two answers, with a plain lag taken out and with the forces behind the filter, the one that simulates unseen data better. Where the
// other does about as well, its numbers are within the intervals.
Diagnosis of_lag_and_filter(const Diagnosis& behind_lag, const Diagnosis& behind_filter, double corner_Hz);

}  // namespace diagnosis::runs

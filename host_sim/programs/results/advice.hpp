// What the core found out about the data, in words: what they cannot tell apart, what to measure next, skewed channels.
#pragma once
#include <string>
#include <vector>

#include "host_sim/programs/results/estimate_result.hpp"

namespace host_sim {

// "add a record excited near 17.3 Hz as well"; empty where nothing is to be done. level_ratio: of the largest level that
// the data hold to the smallest, 1 for one level. skews: of these estimates.
std::string advice_text(const rig_file::RigModel& model, const firmware::Estimates& estimates,
                        const std::vector<SkewResult>& skews, double level_ratio);

// "viscous[1-0] +100 %, viscous[1-2] -83 %": the change of parameters that these data show least.
std::string unresolved_text(const rig_file::RigModel& model, const firmware::Estimates& estimates);

// Displacements and accelerations, measured or derived, whose lateness against the velocity was measured.
std::vector<SkewResult> skews_of(const rig_file::RigModel& model, const firmware::Estimates& estimates,
                                 const std::vector<Record>& records);

// "displacement_1_m is 400 us late against the velocity (+- 2): ...", and what takes it away.
std::string skew_note(const SkewResult& skew);

}  // namespace host_sim

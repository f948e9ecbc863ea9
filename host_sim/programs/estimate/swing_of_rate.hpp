// Arms and pendulums of which the rate alone is measured, by a gyroscope: how far they swing, and what that does to a gravity torque.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Where a rate alone is measured the core integrates it as it comes, and every signal passes the high-pass that takes the drift off. What is
// linear in the angle holds behind it as before it; sin(u) does not. Of a link to the ground with a gravity torque whose angle bends the law by
// more than 2 % (rms of u - sin u over that of u; 0.4 rad) the numbers that were VALID are BIAS_SUSPECT: pendulums that swing by 1
// to 2 rad came out 4 to 17 % off. Returns what to say of each.
std::vector<std::string> doubt_bent_gravity(const rig_file::RigModel& model, const std::vector<Record>& records,
                                            std::vector<ParameterResult>& parameters);

}  // namespace host_sim

// Channels of two DOFs whose cables (or columns) were exchanged: each fits the motion of the other DOF and not its own.
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/one_motion/integrals.hpp"

namespace host_sim::data_check {

// One fault for each pair of exchanged channels; nothing where a DOF has one motion channel alone. With three channels a
// DOF the exchanged quantity is the one that its two others disagree with; with two it is one of both, and the finding
// says so.
std::vector<Finding> check_exchanged(const Record& record, Integrals& integrals);

}  // namespace host_sim::data_check

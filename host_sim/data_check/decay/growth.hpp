// Motion that grows by itself: what drives the rig is not in the recording.
#pragma once
#include <optional>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Of a record of one DOF without a force and without a moving base. A rig that nobody pushes only loses energy, so the
// mean square of its motion about the mean of each tenth of the record falls from tenth to tenth, or begins where it is let
// go. A fault where it is half as much again twice in succession and four times as much in all: a release in the
// middle of a tenth raises it once, and so does a blow. Nothing is said of a record of fewer than ten periods.
std::optional<Finding> find_growth(const Record& record);

}  // namespace host_sim::data_check

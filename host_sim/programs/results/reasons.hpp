// Why a parameter of an estimation has no answer, and what of the records that has to do with.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/programs/results/estimate_result.hpp"

namespace host_sim {

bool hidden_by_noise(firmware::EstimateStatus status, const EstimateResult& result);
// Empty where it has one.
std::string reason(firmware::EstimateStatus status, const EstimateResult& result);

// Whether the rig file tells any force of its own.
bool states_a_coefficient(const rig_file::RigModel& model);
// Whether every DOF with a displacement has a velocity or an acceleration beside it.
bool has_rates(const std::vector<Record>& records);
// Of the DOF that swings least often, in all records together.
std::optional<size_t> fewest_swings(const std::vector<Record>& records);

}  // namespace host_sim

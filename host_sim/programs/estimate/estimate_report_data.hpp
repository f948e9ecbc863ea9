// What `host_sim estimate` finds, as the data of its page and of its exported files.
#pragma once
#include <string>
#include <vector>

#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/records/record.hpp"
#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/response/modes.hpp"

namespace host_sim {

// Modes of the rig with the estimates; empty where a DOF has no mass.
std::vector<UncertainMode> estimated_modes(const rig_file::RigModel& model, const EstimateResult& result);

// Simulates the rig with the estimates beside the first record, and looks at all of them.
reports::EstimateReportData estimate_report_data(const rig_file::RigModel& model, const std::vector<Record>& records,
                                                 const EstimateResult& result);

}  // namespace host_sim

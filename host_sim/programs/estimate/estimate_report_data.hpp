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

// simulated: the rig with the estimates beside each record, as judge_fit left it. The waveforms are those of the record
// that the simulation misses most.
reports::EstimateReportData estimate_report_data(const rig_file::RigModel& model, const std::vector<Record>& records,
                                                 const EstimateResult& result, const std::vector<Record>& simulated);

reports::WarrantView warrant_view(const WarrantResult& warrant);

}  // namespace host_sim

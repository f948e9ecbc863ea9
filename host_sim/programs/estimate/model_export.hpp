// The estimated rig for other programs: DIR/model.json, DIR/model.mat and the figures' data as CSV.
#pragma once
#include <string>

#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/response/modes.hpp"

namespace host_sim {

// model.json (schema "model/1") and model.mat hold the same: parameters with their covariance, natural frequencies
// (Hz) and damping ratios (1) with intervals, mode shapes, and the linear part as state space A, B, C, D with the state
// [x; v], the forces of all DOFs as input and [x; v; a] as output. response_<n>.csv: frequency_Hz, measured, simulated,
// coherence. Makes the folder. Throws OutputError.
void export_model(const std::string& directory, const rig_file::RigModel& model, const EstimateResult& result,
                  const std::vector<UncertainMode>& modes, const reports::RigViews& views);

}  // namespace host_sim

// Frequency responses with coherence, measured and simulated by the same averages.
#pragma once
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"
#include "host_sim/reports/data/report_data.hpp"

namespace host_sim::reports {

// One for each driven and each moved DOF (with many, of the driven DOFs alone); a note where there is none.
void add_responses(const rig_file::RigModel& rig, const std::vector<Record>& records,
                   const std::vector<Record>& simulated, RigViews& views);

}  // namespace host_sim::reports

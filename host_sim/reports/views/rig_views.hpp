// Frequency responses, modes, force-state maps and residual spectra of a rig beside its records.
#pragma once
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"
#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/response/modes.hpp"

namespace host_sim::reports {

// rig: every coefficient a number, fits the records' channels. Views that the sensors cannot give are left out and a
// note says so: a map needs the displacement of the link's ends (integrated accelerations drift), a response a measured
// force.
// simulated: the rig beside each record, or empty where it cannot be simulated.
RigViews rig_views(const rig_file::RigModel& rig, const std::vector<Record>& records,
                   const std::vector<Record>& simulated);

std::vector<ModeRow> mode_rows(const std::vector<UncertainMode>& modes);
// Of a rig whose coefficients have no covariance: values without intervals.
std::vector<ModeRow> mode_rows(const rig_file::RigModel& rig);

// Is the displacement of the link's ends measured (the ground's and a resting base's is known)?
bool elongation_measured(const Record& record, const rig_file::Link& link);

}  // namespace host_sim::reports

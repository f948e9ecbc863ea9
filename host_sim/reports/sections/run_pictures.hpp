// The pictures of the run page: the counterparts of the paper's figures.
#pragma once
#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/data/run_report_data.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

// An estimate inside its interval as the windows close.
Plot convergence_picture(const RunParameter& parameter);
// What the sensors deliver beside what the rig does; nothing where the level has no channels.
void add_signals(Page& page, const RunRecord& record);
// The rig's acceleration beside that simulated with the estimates, where they differ most.
void add_accelerations(Page& page, const RunRecord& record);

}  // namespace host_sim::reports

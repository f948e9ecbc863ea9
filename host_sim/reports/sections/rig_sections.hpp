// The sections of every page that show a rig as a vibration engineer looks at it.
#pragma once
#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/page/page.hpp"

namespace host_sim::reports {

// Modes, frequency responses with coherence, force-state maps, residual spectra; what is empty has no section.
void add_rig_sections(Page& page, const RigViews& views);

}  // namespace host_sim::reports

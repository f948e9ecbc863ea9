// Records through the fixed-point core, alone or on a whole board of fakes, and what it makes of them.
#pragma once
#include "host_sim/programs/estimate/estimation.hpp"

namespace host_sim {

// One run over the records in their order, with their channels as they are. from_end: the records come last sample first (see
// from_its_end.hpp). Estimation::simulated stays empty.
Estimation run_core(const rig_file::RigModel& model, const std::vector<Record>& records,
                    const EstimationOptions& options, bool from_end);

}  // namespace host_sim

// Faults in what is left out of a record of free decays.
#pragma once
#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// A clipped blow, spikes from the hand that lets go: what is left out of a free decay (release.hpp) harms nobody. Such faults become
// mere information.
void forgive_what_is_left_out(const Record& record, const rig_file::RigModel* model, RecordReport& report);

}  // namespace host_sim::data_check

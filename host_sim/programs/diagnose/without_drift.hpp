// Displacements that drift below all that drives the rig, where a diagnosis cannot explain them.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Where the diagnosis found neither that the rig file explains the records nor why it does not, and a displacement is slower than all that
// drives the rig (slow_drift.hpp), the records are diagnosed without what is slow. Where that leaves less than half of what was missed it stands, in
// `found` and the records; returns what to say of it. Empty: all is as it was.
std::string diagnose_without_drift(const rig_file::RigModel& rig, std::vector<Record>& training,
                                   std::vector<Record>& unseen, diagnosis::Diagnosis& found);

}  // namespace host_sim

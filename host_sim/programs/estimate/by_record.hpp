// Records that contradict each other: what each of them says by itself.
#pragma once
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// The scatter between records widens an interval of all of them, and where they are few it is hardly known: 0.020 and
// 0.030 N m of two coast-downs became 0.021 +- 0.005. Where an interval is wider than 5 % of its number, each record is estimated by
// itself. Two that are VALID or UNTESTED, over 5 % and over five of their joint standard deviations apart are told in a note; a
// coefficient whose interval misses one of them is MODEL_SUSPECT if it was VALID: no one number is that of all records.
// records: as they were estimated, prepared.
void doubt_what_records_contradict(const rig_file::RigModel& model, const std::vector<Record>& records,
                                   EstimateResult& result);

}  // namespace host_sim

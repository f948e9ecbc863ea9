// Times in another unit than seconds.
#pragma once
#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// unit: a velocity that is f times too large for the displacement, and an acceleration f^2 times, are one clock that counts in another
// unit: the two findings are replaced by one of `t_s`, as is a spreadsheet's day number: faults. Where the rig file says that no mode is
// slower than half the sampling rate it is a doubt: a rig may be driven below its resonances.
void find_time_unit(const Record& record, const rig_file::RigModel* model, RecordReport& report);

}  // namespace host_sim::data_check

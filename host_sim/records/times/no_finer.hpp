// How finely records may be interpolated.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// Throws DataFileError where records were brought to a rate above that of the fastest of them: between its samples there is
// interpolation alone, whose errors are alike from sample to sample as no noise's are, and a right rig would have to answer for them.
// Ticks have no rate of their own.
void require_no_finer(const std::vector<Record>& records, double rate_Hz);

}  // namespace host_sim

// Displacements that are sampled far faster than they move.
//
// Where a displacement alone is measured, its second slope has the noise of the whole band below the low-pass, a tenth of the sample
// rate. Means of several samples have less noise in a band that still holds the motion; means of all channels obey the same
// equations.
#pragma once
#include <string>
#include <vector>

#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

// Replaces the samples by means of so many that the motion stays within some twentieth of the new rate, where there is neither a
// velocity nor an acceleration. Returns what to say of it; empty: the records are as they were.
std::string average_slow_motion(SharedRecords& records);

}  // namespace host_sim

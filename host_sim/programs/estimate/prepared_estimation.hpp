// The estimation of records as a person has them: thinned, drifts and zeros taken off, then asked of the core.
#pragma once
#include <string>
#include <vector>

#include "host_sim/programs/estimate/estimation.hpp"
#include "host_sim/programs/shared/shared_records.hpp"

namespace host_sim {

// Changes the records to what the core is given (high-passes undone, thinned, drifts and zeros taken off), and leaves the units of converters' codes in the rig file to the data where those have
// changed. notes: gets what to say of it. Estimated twice: where forces hold a displacement off its mean; where a free motion seems to
// swing about another place than its zero, from either, and what suspects nothing, warrants more or scatters less stands; where a
// displacement is slower than all that drives the rig, as recorded and without, which stands where it warrants more and suspects
// nothing. Throws as estimate_records().
Estimation estimate_prepared(rig_file::RigModel& model, SharedRecords& records, const EstimationOptions& options,
                             std::vector<std::string>& notes);

}  // namespace host_sim

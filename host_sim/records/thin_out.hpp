// Records that were sampled more often than their motion needs, at a fraction of their rate.
#pragma once
#include <cstddef>
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// Half of the low-pass, in new sample periods: what it leaves out of both ends of a record.
constexpr size_t kThinningReach = 8;

// The low-pass of a record that keeps every factor-th sample, from -kThinningReach to kThinningReach new periods, its sum 1:
// a root-raised-cosine (Proakis, Digital Communications, eq. 9.2-25) with a roll-off of a half. It passes what is below a quarter
// of the new rate as it is, and nothing above three quarters; between them what folds together adds up to the same power, so that
// white noise is white noise again.
std::vector<double> thinning_filter(size_t factor);

// Every channel through the same filter, so that the equations of motion hold among them as before. factor 1: as it is. A record
// that is shorter than the filter is left with no sample.
Record thinned(const Record& record, size_t factor);
size_t thinned_samples(size_t samples, size_t factor);

}  // namespace host_sim

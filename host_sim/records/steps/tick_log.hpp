// An encoder that is logged by its ticks: a row for each, one step up or down, at the instant at which it passed.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// A row for each mark that passed (a tooth, a magnet, a revolution), but for those that were missed: from row to row the value grows or
// falls by whole steps in one direction, and takes as many times longer as there are steps. It is exact at its instant: the step is then
// no resolution. Of values that are sampled and rounded the steps differ and the times do not.
bool counts_marks(const std::vector<double>& time_s, const std::vector<double>& values);

// The step of a log of ticks: a record of one channel, in which 99 of 100 rows are one step up or down and the others (a tick was
// lost) are whole steps, and the motion turns at least once. 0 where the record is none.
double tick_step(const Record& record);

// The log of such ticks at rate_Hz. A tick is where the encoder passes from one count to the next: half a step below the new one
// on the way up, half a step above it on the way down. Between ticks the value is that of the polynomial through the six around, and
// never leaves the count's own step, however long the pause: that is a turn or a rest and no gap. The first row says
// from where on and is left out. recorded_step is the step. Throws DataFileError where the rate gives fewer than four samples from one
// turn to the next (eight a period, as resampled() wants them), or too many for the memory.
Record resampled_ticks(const Record& record, double step, double rate_Hz);

}  // namespace host_sim

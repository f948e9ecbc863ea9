// Flat tops: a channel that stays at its highest or lowest value where the motion went on.
#pragma once
#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {

// Amid noise: runs of exactly equal values at an end of the range that chance brings in one record of 10,000 (from the
// share of equal neighbours inside the range). Without noise: runs that are entered and left at a slope which a smooth
// turn or a stop does not have, and beyond which more than three steps of resolution are missing; likewise stretches
// that are flat within the noise, where noise came in behind what saturates (not of a force: between two blows it is
// flat within its noise; nor of motion that rests at zero, or that the other channels know to be held there, plateau.hpp).
// Motion that stops, a coarse encoder's turning point, and forces commanded as squares or ramps
// are none of it.
// The limits are the converter's ends in SI; equal where they are not known. record: what the channel is from, where the
// other channels are to be asked.
std::optional<Finding> find_clipping(const Channel& channel, const Statistics& statistics, double lower_limit,
                                     double upper_limit, const Record* record = nullptr);

// The stretches of samples that the finding is about, in their order.
std::vector<Run> clipped_runs(const Channel& channel, const Record& record);

}  // namespace host_sim::data_check

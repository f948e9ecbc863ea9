// How long the first batches of a level are (WindowConfiguration::batch_samples) where it is known beforehand how long the level is.
//
// A level's batches double whenever its table is full. One of more than 128 * 32 samples ends with longer ones than 32 whatever it
// began with: where that is certain it begins with them, and has the same batches at its end. What falls away is the work of closing
// the shorter ones and of merging them. Estimates on the way have fewer rows: the first batch is there after a 66th of the level at
// the latest.
#pragma once
#include <cstdint>

namespace rig_file {

// level_samples: of the shortest level, as they are pushed. 0, the core's own choice, where batches of 32 may remain; else 64 or 128.
uint32_t first_batch_samples(uint64_t level_samples);

}  // namespace rig_file

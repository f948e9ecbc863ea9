// Two fits over the same windows, block by block.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

// How much less the second leaves than the first, paired over blocks, as a normal deviate.
double paired_z(const Fitted& first, const Fitted& second);
// The same of each block's own share, so that a loud one counts as a quiet one.
double paired_share_z(const Fitted& first, const Fitted& second);
// Seen and unseen blocks together.
Fitted all_blocks(const State& s);

}  // namespace diagnosis::runs

// The corner at which a fused velocity passes from the displacement's slope to the acceleration's integral.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace rig_file {

// Its time constant as a power of two of sample periods: least noise, of those whose start, which tells nothing, is no more than
// half of the motion.
int leak_shift(const firmware::CoreConfiguration& c, const SignalRanges& ranges, int node);

}  // namespace rig_file

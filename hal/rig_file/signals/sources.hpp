// Which channel each signal is made from.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace rig_file {

// Displacement with acceleration is fused, unless another node needs a filter that all signals have to pass.
void choose_sources(firmware::CoreConfiguration& c, const SignalRanges& ranges);

}  // namespace rig_file

// The filters of planned signals as the integers of the core.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace rig_file {

// Of every signal that is available, and of friction's sign.
void make_filters(firmware::CoreConfiguration& c, const SignalRanges& ranges);

}  // namespace rig_file

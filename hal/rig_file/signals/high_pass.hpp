// Where the high-pass of integrated signals lies.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace rig_file {

// Of a configuration whose sources are chosen.
void choose_high_pass(firmware::CoreConfiguration& c, const SignalRanges& ranges);

// Of a period of the slowest motion to the time constant of a corner that follows it.
int octaves_of_period(const firmware::CoreConfiguration& c);

}  // namespace rig_file

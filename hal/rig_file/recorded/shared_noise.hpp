// What the noise of one channel puts into several signals and into neighbouring samples, where signals pass filters: mean
// products that the energies and the score tests take out (firmware/configuration/configuration.hpp).
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/recorded/channel_noise.hpp"

namespace rig_file {

struct SignalRanges;

// As firmware/conditioning makes the signal q of a node from its codes, without its rounding: sections of the high-pass, the
// last of them integrations (a displacement from a velocity: the first).
void high_pass(const firmware::CoreConfiguration& c, int node, int q, std::vector<double>& input);

// Fills the mean products and how far they may be off, of a configuration whose signals are planned.
void find_shared_noise(firmware::CoreConfiguration& c, const SignalRanges& ranges);

}  // namespace rig_file

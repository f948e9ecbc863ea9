// What is asked of a plan of signals: which are derived, fused, delayed, integrated.
#pragma once
#include <string>

#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/filter_design.hpp"
#include "hal/rig_file/signal_plan.hpp"

namespace rig_file {

constexpr int kF = 0, kX = 1, kV = 2, kA = 3;  // force, displacement, velocity, acceleration: signals of a node

std::string node_name(int node);  // "DOF 1", "the base"

// A velocity made of displacement and acceleration together.
bool fused(const firmware::CoreConfiguration& c, int node, int q);
// How often the signal's channel is differentiated to it.
int derivatives(const firmware::CoreConfiguration& c, int node, int q);
// How often the most integrated signal is.
int most_integrations(const firmware::CoreConfiguration& c);
// What the low-pass of a plan that differentiates lets through.
Band band(const firmware::CoreConfiguration& c, const SignalRanges& ranges);
// Noise that is in the neighbours of a sample although nothing is filtered. A displacement tells: its motion does not reach the top
// of the spectrum.
bool coloured_displacement(const firmware::CoreConfiguration& c, const SignalRanges& ranges);
bool has_friction(const firmware::CoreConfiguration& c);

}  // namespace rig_file

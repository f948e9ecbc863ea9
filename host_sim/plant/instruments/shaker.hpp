// What drives the rig in one level of a scenario.
#pragma once
#include "host_sim/plant/instruments/signal.hpp"
#include "host_sim/plant/scenario/scenario.hpp"

namespace host_sim {

// t = 0 is the level's first sample after settling. The random force depends on seed and level number alone.
Excitation level_excitation(const Scenario& scenario, size_t level, uint64_t seed);

// Force and motion of every DOF (and of a base that some level moves) over settling, measurement and run-out
// (ExcitationLevel::recorded() samples), without sensors.
// offset_s shifts all sample times: negative for a channel that is late.
Record simulate_level(const Scenario& scenario, size_t level, uint64_t seed, double offset_s = 0.0);
// The same under an excitation that is there already: that of a random band takes as long as the rig's motion.
Record simulate_level(const Scenario& scenario, size_t level, const Excitation& excitation, double offset_s = 0.0);

}  // namespace host_sim

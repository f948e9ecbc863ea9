// Sensors and converters: from the rig's true motion to codes with noise, offset, drift, delay, rounding and clipping.
#pragma once
#include <vector>

#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/plant/instruments/signal.hpp"
#include "host_sim/plant/scenario/scenario.hpp"

namespace host_sim {

// What was sampled, level by level: settling, measurement and run-out (ExcitationLevel::recorded() samples). All levels
// have the same channels, one calibration for each.
struct MeasuredLevels {
  std::vector<rig_file::ChannelCalibration> calibrations;
  std::vector<Excitation> excitation;
  std::vector<Record> truth;  // noise-free, undelayed, all channels of every DOF
  std::vector<Record>
      measured;  // SI values that the codes stand for: (code - offset_code) * unit_per_code, delays still in
};

// The channels that a scenario measures: the sensors' quantities of every DOF (force only where some level drives the
// DOF) and of the base where a level moves it.
std::vector<Channel> measured_channels(const Scenario& scenario);

// Simulates and measures every level. unit_per_code: from the rig's [[channel]] entry, else full_scale / 2^(bits-1) as
// it stands, else the smallest power of two that keeps headroom * largest value within full scale. Throws PlantError.
MeasuredLevels measure(const Scenario& scenario, uint64_t seed);

}  // namespace host_sim

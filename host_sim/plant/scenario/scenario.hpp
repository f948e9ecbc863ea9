// One simulated experiment: the rig, the values that the plant really has, the excitation programme, the sensors.
// docs/scenarios.md describes the file (schema "scenario/1").
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/plant/motion/simulate.hpp"

namespace host_sim {

constexpr size_t kRunOutSamples = 128;

enum class LevelKind { kSine, kRandom, kFreeDecay, kBaseSine };

struct ExcitationLevel {
  LevelKind kind = LevelKind::kSine;
  int dof = 1;             // where the force acts (kSine, kRandom)
  double amplitude = 0.0;  // kSine: N (N m); kBaseSine: m (rad)
  double rms_N = 0.0;      // kRandom
  double frequency_Hz = 0.0;
  double low_Hz = 5.0, high_Hz = 50.0;
  size_t settle_samples = 0;                // before the measurement
  size_t samples = 0;                       // sample periods to be measured
  size_t run_out_samples = kRunOutSamples;  // beyond the measurement, for filters that look further
  InitialState initial;
  size_t recorded() const { return settle_samples + samples + 1 + run_out_samples; }
  bool periodic() const { return kind == LevelKind::kSine || kind == LevelKind::kBaseSine; }
};

// What one sensor does to its channel. Values in SI units of the channel.
struct SensorChannel {
  double noise_percent = 0.0;    // of the channel's rms within the level
  double noise_corner_Hz = 0.0;  // 0: white; else first-order coloured, same rms
  int bits = 24;                 // converter: 12, 16 or 24
  double full_scale = 0.0;       // 0: chosen from the data
  double offset = 0.0;
  double drift_per_s = 0.0;
  double delay_us = 0.0;  // the channel shows what was that long ago
};

struct SensorSettings {
  std::vector<Quantity> quantities = {Quantity::kForce, Quantity::kDisplacement, Quantity::kVelocity,
                                      Quantity::kAcceleration};
  SensorChannel every;                           // of channels without an entry of their own
  double headroom = 1.25;                        // chosen full scale: at least this times the largest value
  std::map<std::string, SensorChannel> channel;  // by channel name
  std::vector<std::string> absent;               // channels that do not exist although their quantity is listed
};

struct Scenario {
  std::string name, description;
  rig_file::RigModel rig;     // what the estimator is told
  rig_file::RigModel plant;   // what is simulated: all numbers
  std::vector<double> truth;  // per unknown, in the order of the core's unknowns
  double sample_rate_Hz = 1000.0;
  std::vector<ExcitationLevel> levels;
  SensorSettings sensors;
  double sample_period_s() const { return 1.0 / sample_rate_Hz; }
};

// Throws rig_file::RigFileError: file, line, key and what was expected. A "rig" or "plant" path is relative to the
// file.
Scenario read_scenario_file(const std::string& path);
Scenario parse_scenario(std::string_view toml_text, const std::string& file);

// The shipped scenarios.
std::vector<std::string> shipped_scenario_names();
std::string shipped_scenario_text(const std::string& name);  // as a scenario file; empty: no such name
// A shipped name, else a file. Throws RigFileError, naming the shipped ones, where it is neither.
Scenario load_scenario(const std::string& name_or_file);

}  // namespace host_sim

// One blind draw: what the engineer believes (rig file), what the sensors say (records) and, kept apart, the truth.
// Everything follows from the seed and the settings.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "conditions.hpp"
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"
#include "integrator.hpp"

namespace hidden_rig {

struct Settings {
  std::string condition = "random_1pct";
  std::string sensors = "xva";            // of every DOF: which of x, v, a; "mixed": drawn for each DOF
  std::string hidden = "none";            // a word of effects(), "any", "two" (any two) or "none"
  double rho_low = 0.05, rho_high = 0.6;  // rms(hidden force) / rms(damping force of its link)
  int masses = 0;                         // 0: as the condition draws
  double fault = 0;                       // strength of a fault of a channel (seconds late, relative gain); 0: drawn
};

// Words that can be hidden: link and DOF effects, drive_dead_band, sensor_delay, sensor_gain, mains_hum; on the force
// channel force_delay and force_hold; data faults dead, clipped, spikes, polarity, unit, drift.
const std::vector<std::string>& effects();

struct Hidden {
  std::string effect, where;  // the contract's words: "link 1-2", "dof 3", "channel velocity_2_m_s"
  double rho = 0;             // rms(hidden force) / rms(damping force); faults of the measurement: relative size
  double strength = 0, shape = 0;
};

struct TrueCoefficient {  // of a coefficient that the rig file calls "estimate"
  std::string name;       // "viscous[1-2]"
  double value = 0;       // mean over the records
  std::vector<double> of_record;
};

struct Draw {
  rig_file::RigModel rig;
  std::vector<host_sim::Record> records;
  TrueRig true_rig;
  std::vector<TrueCoefficient> coefficients;
  std::vector<Hidden> hidden;  // empty: nothing
  std::vector<Motion> motion;  // of every record, without sensors
  std::vector<Drive> drive;
  std::map<std::string, int> redrawn;  // why draws before this one were thrown away, and how often
};

Draw make_draw(uint64_t seed, const Settings& settings);  // throws std::runtime_error after 200 that were thrown away
std::string truth_json(uint64_t seed, const Settings& settings, const Draw& draw);

}  // namespace hidden_rig

// One blind draw: a rig file, a record and, kept apart, the truth that the diagnosis has to find. All of it follows
// from the seed; the settings only narrow what is drawn (for one line of the report).
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "hidden_rig.hpp"
#include "host_sim/records/record.hpp"

namespace hidden {

enum class Hide { kNothing, kOne, kTwo, kOutside, kSensorFault };

struct Settings {
  Hide hide = Hide::kOne;
  double noise = 0.01;          // of each channel's rms
  std::string sensors = "xva";  // which of displacement, velocity, acceleration
  double noise_corner_Hz = 0;   // first-order coloured noise with this corner; 0: white
  int bits = 0;                 // quantised to this many bits over 1.25 times the channel's peak; 0: not at all
  double seconds = 20;
  Drive drive = Drive::kSmooth;
  double rho_low = 0.05, rho_high = 0.6;
  std::string kind;     // only this effect
  std::string channel;  // a sensor's fault: only in this channel
  int dofs = 0;         // only this many masses
};

struct Hidden {
  std::string effect, where;  // the contract's words: "link 1-2", "dof 3", "channel velocity_2_m_s"
  double rho = 0;             // rms(hidden force) / rms(damping force of its link); sensor faults: relative size
  double strength = 0;        // SI
};

struct Draw {
  rig_file::RigModel rig;   // what the engineer believes
  host_sim::Record record;  // what the sensors say
  TrueRig true_rig;
  std::vector<Hidden> truth;  // empty: nothing hidden; effect "outside": not in the vocabulary
};

Draw make_draw(uint64_t seed, const Settings& settings);
Settings settings_of_seed(uint64_t seed);  // a mix of every class, for the committed test

}  // namespace hidden

// Records of a chain of two masses, integrated here; faults are put into them by the tests.
//   m1 = 2 kg to ground k = 2000 N/m, c = 4 N s/m; to m2 = 1 kg k = 1500 N/m, c = 3 N s/m
#pragma once
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace made {

rig_file::RigModel chain();

enum class Drive { kRandom, kTwoTones, kSweep, kHammer, kDecay, kDecayToRest, kRelease };

struct Options {
  Drive drive = Drive::kRandom;
  std::string sensors = "xva";  // of both DOFs
  double noise = 1e-3;          // of each channel's rms
  double encoder_m = 0.0;       // step of the displacement; 0: none
  double rate_Hz = 1000.0, duration_s = 20.0;
  double friction_N = 0.0;  // Coulomb friction of mass 1 to ground
  unsigned seed = 1;
};

host_sim::Record record(const Options& options = {});

std::vector<double>& values(host_sim::Record& record, const std::string& name);

}  // namespace made

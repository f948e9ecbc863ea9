// One shaft with a damper and dry friction that a torque turns: its record and the rig file that knows none of its numbers.
#pragma once
#include <utility>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace shaft {

// At 100 Hz.
inline host_sim::Record record(const char* file, std::vector<double> torque, std::vector<double> speed) {
  host_sim::Record made;
  made.file = file, made.sample_period_s = 0.01;
  made.channels = {{"torque_1_N_m", host_sim::Quantity::kForce, 1, std::move(torque)},
                   {"angular_velocity_1_rad_s", host_sim::Quantity::kVelocity, 1, std::move(speed)}};
  return made;
}

inline rig_file::RigModel rig() {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].rotating = true, rig.dofs[0].mass_kg.estimate = true;
  rig.links[0].a = 1, rig.links[0].viscous_N_s_m.estimate = true, rig.links[0].coulomb_N.estimate = true;
  return rig;
}

}  // namespace shaft

// Arms and pendulums.
#pragma once
#include <algorithm>

#include "hal/rig_file/rig_model.hpp"

namespace host_sim {

// Whether a link has a gravity torque, of its own or as an effect.
inline bool weighs(const rig_file::Link& link) {
  return link.gravity_torque_N_m.estimate || link.gravity_torque_N_m.value != 0 ||
         std::any_of(link.effects.begin(), link.effects.end(),
                     [](const rig_file::Effect& e) { return e.kind == "missing_gravity_torque"; });
}

}  // namespace host_sim

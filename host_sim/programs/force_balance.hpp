// The force that a rig's model leaves unexplained at each sample of a record, for rigs that cannot be simulated freely.
#pragma once
#include <vector>

#include "hal/configuration/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

struct ForceBalance {
  std::vector<std::vector<double>>
      residual;  // per DOF, N: f - m a - sum of link forces; 8 samples shorter than the record
  std::vector<std::vector<double>> reference;  // per DOF, N: the measured force, or m a where there is none
};

// Missing velocities and accelerations are derived (derivative.hpp), missing displacements integrated by trapezoids.
// rig: every coefficient a number.
ForceBalance force_balance(const rig_file::RigModel& rig, const Record& record);

}  // namespace host_sim

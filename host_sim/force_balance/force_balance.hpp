// The force of each term of a rig's model at each sample of a record, and the force that the model leaves unexplained.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// All series are 8 samples shorter than the record: sample i of theirs is sample i + kDerivativeMargin of the record.
using Series = std::vector<double>;

struct ForceTerm {
  std::string name;           // "viscous[1-2]"
  bool conservative = false;  // gives back what it takes: stiffness, gravity
  Series force;               // N (N m): subtracted from DOF a of the link and added to b
};

struct LinkBalance {
  Series elongation, rate;
  std::vector<ForceTerm> terms;  // those with a coefficient other than 0
  Series total() const;          // of all terms
};

struct ForceBalance {
  std::vector<Series> residual;   // per DOF, N: f - m a - sum of link forces
  std::vector<Series> reference;  // per DOF, N: the measured force, or m a where there is none
  std::vector<Series> drive;      // per DOF, N: the measured force; zeros where there is none
  std::vector<Series> inertia;    // per DOF, N: m a
  std::vector<Series> velocity;   // per DOF
  std::vector<LinkBalance> links;
};

// Missing velocities and accelerations are derived (derivative.hpp), missing displacements integrated by trapezoids.
// rig: every coefficient a number.
ForceBalance force_balance(const rig_file::RigModel& rig, const Record& record);

}  // namespace host_sim

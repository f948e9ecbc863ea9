// The linear part of a rig as matrices: M a + C v + K x = f, from its masses, stiffnesses, gravity torques at rest
// (G sin u = G u near u = 0) and viscous dampers. Friction and extension terms are not linear and are left out.
#pragma once
#include <Eigen/Dense>

#include "hal/rig_file/rig_model.hpp"

namespace host_sim {

struct LinearRig {  // N DOFs: N x N each, SI units
  Eigen::MatrixXd mass, damping, stiffness;
};

// rig: every coefficient a number.
LinearRig linear_rig(const rig_file::RigModel& rig);

// A coefficient between two ends acts on both; an end below nought (the ground, the base) is no unknown of the equations.
void add_between(Eigen::MatrixXd& matrix, Eigen::Index a, Eigen::Index b, double coefficient);

// d/dt [x; v] = A [x; v] + B f,  y = [x; v; a] = C [x; v] + D f.
struct StateSpace {
  Eigen::MatrixXd a, b, c, d;
};
// Throws std::domain_error where a DOF has no mass.
StateSpace state_space(const LinearRig& rig);

}  // namespace host_sim

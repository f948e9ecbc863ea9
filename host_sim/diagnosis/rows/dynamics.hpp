// The linear dynamics of a model.
#pragma once
#include <vector>

#include "rows.hpp"

namespace diagnosis {

bool is_linear(Kind kind);  // a mass, a spring, a damper

// A force per motion (DOFs x DOFs). Of terms that are not linear what accelerates, stores and dissipates as they do, or nothing.
struct Dynamics {
  enum class Others { kAlike, kNone };
  Eigen::MatrixXd mass, stiffness, viscous;
  Eigen::VectorXd base_stiffness, base_viscous;  // what the motion of the base does to each DOF
  Dynamics(const System& system, const std::vector<ActiveTerm>& model, Others others);
};

}  // namespace diagnosis

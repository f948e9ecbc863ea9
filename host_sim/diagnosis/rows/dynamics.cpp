#include "dynamics.hpp"

namespace diagnosis {

bool is_linear(Kind kind) {
  return kind == Kind::kMass || kind == Kind::kMassError || kind == Kind::kStiffness || kind == Kind::kStiffnessError ||
         kind == Kind::kViscous || kind == Kind::kMissingViscous;
}

Dynamics::Dynamics(const System& system, const std::vector<ActiveTerm>& model, Others others) {
  const Eigen::Index n = static_cast<Eigen::Index>(system.dofs());
  mass = stiffness = viscous = Eigen::MatrixXd::Zero(n, n);
  for (const ActiveTerm& t : model) {
    if (others == Others::kNone && !is_linear(t.term.kind)) continue;
    const double value = acting_value(model, t);
    const Place place = place_of_force(system, t.term);
    act(mass, place, value * t.column->mass);
    act(stiffness, place, value * t.column->stiffness), act(viscous, place, value * t.column->viscous);
  }
}

}  // namespace diagnosis

#include "dynamics.hpp"

namespace diagnosis {

bool is_linear(Kind kind) {
  return kind == Kind::kMass || kind == Kind::kMassError || kind == Kind::kStiffness || kind == Kind::kStiffnessError ||
         kind == Kind::kViscous || kind == Kind::kMissingViscous;
}

Dynamics::Dynamics(const System& system, const std::vector<ActiveTerm>& model, Others others) {
  const Eigen::Index n = static_cast<Eigen::Index>(system.dofs());
  mass = stiffness = viscous = Eigen::MatrixXd::Zero(n, n);
  base_stiffness = base_viscous = Eigen::VectorXd::Zero(n);
  for (const ActiveTerm& t : model) {
    if (others == Others::kNone && !is_linear(t.term.kind)) continue;
    const double value = acting_value(model, t);
    const Place place = place_of_force(system, t.term);
    act(mass, place, value * t.column->mass);
    act(stiffness, place, value * t.column->stiffness), act(viscous, place, value * t.column->viscous);
    if (t.term.link < 0) continue;
    const rig_file::Link& link = system.links[static_cast<size_t>(t.term.link)];
    const int moved = link.a == rig_file::kBase ? link.b : link.b == rig_file::kBase ? link.a : 0;
    if (moved <= 0) continue;
    base_stiffness[moved - 1] -= value * t.column->stiffness;
    base_viscous[moved - 1] -= value * t.column->viscous;
  }
}

}  // namespace diagnosis

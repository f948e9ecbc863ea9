#include "host_sim/response/linear_rig.hpp"

#include <stdexcept>

namespace host_sim {
namespace {

void add_link(Eigen::MatrixXd& matrix, const rig_file::Link& link, double coefficient) {
  add_between(matrix, link.a - 1, link.b - 1, coefficient);
}

}  // namespace

void add_between(Eigen::MatrixXd& matrix, Eigen::Index a, Eigen::Index b, double coefficient) {
  if (a >= 0) matrix(a, a) += coefficient;
  if (b >= 0) matrix(b, b) += coefficient;
  if (a >= 0 && b >= 0) matrix(a, b) -= coefficient, matrix(b, a) -= coefficient;
}

LinearRig linear_rig(const rig_file::RigModel& rig) {
  const auto n = static_cast<Eigen::Index>(rig.dofs.size());
  LinearRig out{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) out.mass(i, i) = rig.dofs[static_cast<size_t>(i)].mass_kg.value;
  for (const rig_file::Link& link : rig.links) {
    add_link(out.stiffness, link, link.stiffness_N_m.value + link.gravity_torque_N_m.value);
    add_link(out.damping, link, link.viscous_N_s_m.value);
  }
  return out;
}

StateSpace state_space(const LinearRig& rig) {
  const Eigen::Index n = rig.mass.rows();
  for (Eigen::Index i = 0; i < n; ++i)
    if (!(rig.mass(i, i) > 0.0)) throw std::domain_error("DOF " + std::to_string(i + 1) + " has no mass");
  const Eigen::MatrixXd inverse = rig.mass.diagonal().cwiseInverse().asDiagonal();
  StateSpace out;
  out.a = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  out.a.topRightCorner(n, n).setIdentity();
  out.a.bottomLeftCorner(n, n) = -inverse * rig.stiffness;
  out.a.bottomRightCorner(n, n) = -inverse * rig.damping;
  out.b = Eigen::MatrixXd::Zero(2 * n, n);
  out.b.bottomRows(n) = inverse;
  out.c = Eigen::MatrixXd::Zero(3 * n, 2 * n);
  out.c.topRows(2 * n).setIdentity();
  out.c.bottomRows(n) = out.a.bottomRows(n);
  out.d = Eigen::MatrixXd::Zero(3 * n, n);
  out.d.bottomRows(n) = inverse;
  return out;
}

}  // namespace host_sim

#include "tests/bench/baselines.hpp"

namespace bench {
namespace {

constexpr double kForgetting = 0.99999;

double sign(double w) { return w > 0.0 ? 1.0 : (w < 0.0 ? -1.0 : 0.0); }

struct Motion {
  double u, w;
};

// Link l: from DOF l (the last DOF at the end of the chain) to DOF l - 1 or ground.
Motion motion(const Sample& s, int link, int dofs) {
  const auto a = static_cast<size_t>(link < dofs ? link : dofs - 1);
  if (link == 0 || link == dofs) return {s.x[a], s.v[a]};
  return {s.x[a] - s.x[a - 1], s.v[a] - s.v[a - 1]};
}

}  // namespace

EquationRows::EquationRows(int dofs) : row(Eigen::MatrixXd::Zero(dofs, dofs + 2)), rhs(dofs), dofs_(dofs) {}

void EquationRows::fill(const Sample& s) {
  for (int i = 0; i < dofs_; ++i) rhs(i) = s.f[static_cast<size_t>(i)] - kMass_kg * s.a[static_cast<size_t>(i)];
  for (int l = 0; l <= dofs_; ++l) {
    const Motion m = motion(s, l, dofs_);
    const int a = l < dofs_ ? l : dofs_ - 1;
    row(a, l) = m.w;
    rhs(a) -= kStiffness_N_m * m.u;
    if (l > 0 && l < dofs_) {
      row(l - 1, l) = -m.w;
      rhs(l - 1) += kStiffness_N_m * m.u;
    }
    if (l == dofs_) row(a, l + 1) = sign(m.w);
  }
}

RecursiveLeastSquares::RecursiveLeastSquares(int dofs)
    : parameters(Eigen::VectorXd::Zero(dofs + 2)),
      rows_(dofs),
      covariance_(1e6 * Eigen::MatrixXd::Identity(dofs + 2, dofs + 2)) {}

void RecursiveLeastSquares::step(const Sample& sample) {
  rows_.fill(sample);
  for (int i = 0; i < rows_.row.rows(); ++i) {
    // The textbook's three lines, as they are usually typed.
    const Eigen::VectorXd phi = rows_.row.row(i).transpose();
    const Eigen::VectorXd gain = covariance_ * phi / (kForgetting + phi.dot(covariance_ * phi));
    parameters += gain * (rows_.rhs(i) - phi.dot(parameters));
    covariance_ = (covariance_ - gain * (phi.transpose() * covariance_)) / kForgetting;
  }
}

BatchLeastSquares::BatchLeastSquares(int dofs)
    : normal(Eigen::MatrixXd::Zero(dofs + 2, dofs + 2)), right(Eigen::VectorXd::Zero(dofs + 2)), rows_(dofs) {}

void BatchLeastSquares::step(const Sample& sample) {
  rows_.fill(sample);
  normal.noalias() += rows_.row.transpose() * rows_.row;
  right.noalias() += rows_.row.transpose() * rows_.rhs;
}

EnergySumsInDouble::EnergySumsInDouble(int dofs) : dofs_(dofs) {
  const auto links = static_cast<size_t>(dofs + 1);
  viscous_a.assign(links, 0.0);
  viscous_b.assign(links, 0.0);
  coulomb.assign(2, 0.0);
  rhs.assign(static_cast<size_t>(dofs), 0.0);
}

void EnergySumsInDouble::step(const Sample& s) {
  for (int i = 0; i < dofs_; ++i) {
    const auto k = static_cast<size_t>(i);
    rhs[k] += s.v[k] * (s.f[k] - kMass_kg * s.a[k]);
  }
  for (int l = 0; l <= dofs_; ++l) {
    const Motion m = motion(s, l, dofs_);
    const auto a = static_cast<size_t>(l < dofs_ ? l : dofs_ - 1), link = static_cast<size_t>(l);
    viscous_a[link] += s.v[a] * m.w;
    rhs[a] -= s.v[a] * kStiffness_N_m * m.u;
    if (l > 0 && l < dofs_) {
      viscous_b[link] -= s.v[a - 1] * m.w;
      rhs[a - 1] += s.v[a - 1] * kStiffness_N_m * m.u;
    }
    if (l == dofs_) coulomb[0] += s.v[a] * sign(m.w);
  }
}

}  // namespace bench

// The covariance of the rows, and with it their weights.
#include <algorithm>
#include <cmath>

#include "rows.hpp"

namespace diagnosis {
namespace {

// Sampling and smoothing leave this share of a link's damping wrong, noise or not.
constexpr double kKnownFriction = 0.006, kKnownViscous = 0.002;
// The inner weight's spectrum is a few bins wide: so far reaches the noise of a bin, and so strongly.
constexpr Eigen::Index kReach = 2;
double share_of(Eigen::Index distance) { return distance == 0 ? 0.6 : 0.1; }

// Linear dynamics of a model: a force per motion, and what each link's dampers take.
struct Dynamics {
  Eigen::MatrixXd mass, stiffness, viscous;
  std::vector<double> damper, friction;  // per link
  Dynamics(const Rows& rows, const std::vector<ActiveTerm>& model);
  double unknown_damping(const LinkMotion& m, size_t link) const {
    return std::pow(kKnownViscous * damper[link] * m.w_rms, 2) + std::pow(kKnownFriction * friction[link], 2);
  }
  void stiffness_at(double omega, SmallMatrix& out) const {
    out = (stiffness - omega * omega * mass).cast<Complex>() + Complex(0, omega) * viscous.cast<Complex>();
  }
};

// value on a place as a matrix over the DOFs
void add(Eigen::MatrixXd& matrix, const Place& p, double value) {
  if (p.plus >= 0) matrix(p.plus, p.plus) += value;
  if (p.minus >= 0) matrix(p.minus, p.minus) += value;
  if (p.plus >= 0 && p.minus >= 0) matrix(p.plus, p.minus) -= value, matrix(p.minus, p.plus) -= value;
}

Dynamics::Dynamics(const Rows& rows, const std::vector<ActiveTerm>& model) {
  const Eigen::Index n = static_cast<Eigen::Index>(rows.system().dofs());
  mass = stiffness = viscous = Eigen::MatrixXd::Zero(n, n);
  damper.assign(rows.system().links.size(), 0.0), friction = damper;
  for (const ActiveTerm& t : model) {
    const Kind kind = t.term.kind;
    const double value = t.host >= 0 ? t.host_sign * model[static_cast<size_t>(t.host)].value : t.value;
    const Place place = rows.place(t.term);
    add(mass, place, value * t.column->mass);
    if (t.term.link < 0) continue;
    add(stiffness, place, value * t.column->stiffness), add(viscous, place, value * t.column->viscous);
    const size_t link = static_cast<size_t>(t.term.link);
    if (kind == Kind::kViscous || kind == Kind::kMissingViscous) damper[link] += value;
    if (kind == Kind::kCoulomb || kind == Kind::kMissingCoulomb) friction[link] += value;
  }
}

}  // namespace

void Rows::weight(const std::vector<ActiveTerm>& model) {
  const Eigen::Index n = static_cast<Eigen::Index>(system_.dofs());
  const Dynamics dynamics(*this, model);
  auto weights = std::make_shared<Weights>();
  log_determinant_ = 0;
  for (size_t r = 0; r < records_.size(); ++r) {
    const FusedRecord& f = records_[r];
    Eigen::MatrixXd known = Eigen::MatrixXd::Zero(n, n);  // variance per sample of friction, the same in every bin
    for (size_t l = 0; l < system_.links.size(); ++l) {
      const double floor = dynamics.unknown_damping(links_[r][l], l) * static_cast<double>(f.samples) / (2.0 * static_cast<double>(f.last_bin));
      add(known, place_of_link(l), doubt_[r][l] + floor);
    }
    std::array<SmallMatrix, 2 * kReach + 1> near;  // covariances of the bins around the present one
    SmallMatrix d(n, n), sum(n, n);
    const auto covariance = [&](Eigen::Index bin, SmallMatrix& s) {
      dynamics.stiffness_at(f.omega(bin), d);
      Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostDofs, 1> variance(n);
      for (Eigen::Index j = 0; j < n; ++j) variance[j] = f.motion[static_cast<size_t>(j)].variance[bin];
      s.noalias() = d * variance.cast<Complex>().asDiagonal() * d.adjoint();
      s += known.cast<Complex>();
      for (Eigen::Index j = 0; j < n; ++j)
        if (f.force_noise[static_cast<size_t>(j)].size()) s(j, j) += f.force_noise[static_cast<size_t>(j)][bin];
    };
    const auto slot = [&](Eigen::Index i) -> SmallMatrix& { return near[static_cast<size_t>(i) % near.size()]; };
    weights->emplace_back(bins(r), n);
    for (Eigen::Index i = -kReach; i < bins(r); ++i) {
      const Eigen::Index ahead = i + kReach;
      if (ahead < bins(r)) covariance(ahead + f.first_bin, slot(ahead));
      if (i < 0) continue;
      sum.setZero();
      double shares = 0;
      for (Eigen::Index k = -kReach; k <= kReach; ++k) {
        if (i + k < 0 || i + k >= bins(r)) continue;
        sum += share_of(k) * slot(i + k);
        shares += share_of(k);
      }
      sum *= inflation_[r][i] * f.inner_energy / (2 * shares);
      if (i + f.first_bin == 0) sum *= 2;  // the mean is real: all its noise is in one of the two rows
      log_determinant_ += 2 * weights->back().set(i, sum);
    }
  }
  weights_ = weights;
}

void Rows::colour(const std::vector<Balance>& residual, double freedom) {
  for (size_t r = 0; r < records_.size(); ++r) {
    Series& factor = inflation_[r];
    const Series power = (*weights_)[r].power(residual[r]) / (2.0 * static_cast<double>(system_.dofs()));
    Series total(factor.size() + 1);
    total[0] = 0;
    for (Eigen::Index i = 0; i < factor.size(); ++i) total[i + 1] = total[i] + factor[i] * power[i];
    for (Eigen::Index i = 0; i < factor.size(); ++i) {
      const Eigen::Index reach = 6 + i / 8, low = std::max<Eigen::Index>(0, i - reach), high = std::min(factor.size(), i + reach + 1);
      factor[i] = std::max(1.0, (total[high] - total[low]) / static_cast<double>(high - low) / freedom);
    }
  }
}

}  // namespace diagnosis

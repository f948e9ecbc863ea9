// The covariance of the rows, and with it their weights.
#include <algorithm>
#include <cmath>

#include "dynamics.hpp"

namespace diagnosis {
namespace {

// Sampling and smoothing leave this share of a link's damping wrong, noise or not.
constexpr double kKnownFriction = 0.006, kKnownViscous = 0.002;
// The inner weight's spectrum is a few bins wide: so far reaches the noise of a bin, and so strongly.
constexpr Eigen::Index kReach = 2;
constexpr double kOwn = 0.6, kNeighbour = 0.1;

Spectrum smoothed(const Spectrum& s) {
  Spectrum sum = kOwn * s;
  Series shares = Series::Constant(s.size(), kOwn);
  for (Eigen::Index k = 1; k <= kReach; ++k) {
    const Eigen::Index rest = s.size() - k;
    sum.head(rest) += kNeighbour * s.tail(rest), sum.tail(rest) += kNeighbour * s.head(rest);
    shares.head(rest).array() += kNeighbour, shares.tail(rest).array() += kNeighbour;
  }
  return sum.cwiseQuotient(shares.cast<Complex>());
}

// What the dampers of each link take: of viscous coefficients and of friction.
struct Dampers {
  std::vector<double> viscous, friction;
  Dampers(const System& system, const std::vector<ActiveTerm>& model)
      : viscous(system.links.size(), 0.0), friction(viscous) {
    for (const ActiveTerm& t : model) {
      if (t.term.link < 0) continue;
      const Kind kind = t.term.kind;
      const double value = acting_value(model, t);
      const size_t link = static_cast<size_t>(t.term.link);
      if (kind == Kind::kViscous || kind == Kind::kMissingViscous) viscous[link] += value;
      if (kind == Kind::kCoulomb || kind == Kind::kMissingCoulomb) friction[link] += value;
    }
  }
  double unknown(const LinkMotion& m, size_t link) const {
    return std::pow(kKnownViscous * viscous[link] * m.w_rms, 2) + std::pow(kKnownFriction * friction[link], 2);
  }
};

// D V D^H over the bins, D = K - w^2 M + j w C, for variances V of the displacements (one column per DOF, then the base).
Triangle spread(const Dynamics& d, const Series& omega, const Eigen::MatrixXd& variance) {
  const Eigen::Index n = d.mass.rows(), columns = n + 1;
  Eigen::MatrixXd mass(n, columns), stiffness(n, columns), viscous(n, columns);
  mass << d.mass, Eigen::VectorXd::Zero(n);
  stiffness << d.stiffness, d.base_stiffness;
  viscous << d.viscous, d.base_viscous;
  const auto spring = [&](Eigen::Index j, Eigen::Index l) {
    return stiffness(j, l) - omega.array().square() * mass(j, l);
  };
  const auto damper = [&](Eigen::Index j, Eigen::Index l) { return omega.array() * viscous(j, l); };
  const auto tied = [&](Eigen::Index j, Eigen::Index l) {
    return stiffness(j, l) != 0 || mass(j, l) != 0 || viscous(j, l) != 0;
  };
  Triangle sum;
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index k = 0; k <= j; ++k) {
      sum.push_back(Spectrum::Zero(omega.size()));
      for (Eigen::Index l = 0; l < columns; ++l) {
        if (!tied(j, l) || !tied(k, l)) continue;
        const auto v = variance.col(l).array();
        sum.back().real().array() += v * (spring(j, l) * spring(k, l) + damper(j, l) * damper(k, l));
        sum.back().imag().array() += v * (damper(j, l) * spring(k, l) - spring(j, l) * damper(k, l));
      }
    }
  return sum;
}

}  // namespace

void Rows::weight(const std::vector<ActiveTerm>& model) {
  const Eigen::Index n = static_cast<Eigen::Index>(system_.dofs());
  const Dynamics dynamics(system_, model, Dynamics::Others::kAlike);
  const Dampers dampers(system_, model);
  auto weights = std::make_shared<Weights>();
  log_determinant_ = 0;
  for (size_t r = 0; r < records_.size(); ++r) {
    const FusedRecord& f = records_[r];
    Eigen::MatrixXd known = Eigen::MatrixXd::Zero(n, n);  // variance per sample of friction, the same in every bin
    for (size_t l = 0; l < system_.links.size(); ++l) {
      const double floor =
          dampers.unknown(links_[r][l], l) * static_cast<double>(f.samples) / (2.0 * static_cast<double>(f.last_bin));
      act(known, place_of_link(system_, l), doubt_[r][l] + floor);
    }
    const Series omega = Series::LinSpaced(bins(r), f.omega(f.first_bin), f.omega(f.last_bin));
    Eigen::MatrixXd variance = Eigen::MatrixXd::Zero(bins(r), n + 1);
    for (Eigen::Index j = 0; j < n + (f.motion.back().measured ? 1 : 0); ++j)
      variance.col(j) = f.motion[static_cast<size_t>(j)].variance.segment(f.first_bin, bins(r));
    Triangle covariance = spread(dynamics, omega, variance);
    for (Eigen::Index j = 0; j < n; ++j) {
      const Series& noise = f.force_noise[static_cast<size_t>(j)];
      if (noise.size()) covariance[in_triangle(j, j)] += noise.segment(f.first_bin, bins(r)).cast<Complex>();
      for (Eigen::Index k = 0; k <= j; ++k) {
        Spectrum& entry = covariance[in_triangle(j, k)];
        entry.array() += known(j, k);
        entry = (0.5 * f.inner_energy * smoothed(entry)).eval();
        if (f.first_bin == 0) entry[0] *= 2;  // the mean is real: all its noise is in one of the two rows
      }
    }
    weights->emplace_back(n, std::move(covariance));
    log_determinant_ += 2 * weights->back().log_determinant();
  }
  weights_ = weights;
}

}  // namespace diagnosis

// Velocities and accelerations do not tell the slow part of a displacement; a model and the force do.
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

#include "../rows/dynamics.hpp"
#include "sharpen.hpp"

namespace diagnosis {
namespace {

constexpr int kRounds = 3;                   // the slow motion bends the forces that make it
constexpr Eigen::Index kFade = 3, kTop = 6;  // in first bins of the rows: from here to there the model gives way
constexpr double kLeastStiffness = 1e-6;     // of the largest, for a rig that the ground holds in place

bool held_in_place(const Dynamics& d) {
  return d.stiffness.ldlt().vectorD().minCoeff() > kLeastStiffness * d.stiffness.diagonal().maxCoeff();
}

Eigen::MatrixXcd force_per_motion(const Dynamics& d, double omega) {
  return (d.stiffness - omega * omega * d.mass).cast<Complex>() + Complex(0, omega) * d.viscous.cast<Complex>();
}

// Below the rows the model's motion; above what was measured, as far as it is trusted, and for the rest the model's.
Spectrum completed(const FusedRecord& f, const DofMotion& m, const Spectrum& slow) {
  Spectrum y = slow;
  for (Eigen::Index i = f.first_bin; i < y.size(); ++i) {
    const double fade = std::clamp(
        static_cast<double>(kTop * f.first_bin - i) / static_cast<double>((kTop - kFade) * f.first_bin), 0.0, 1.0);
    y[i] = m.trust[i] * m.raw[i] + (1 - m.trust[i]) * fade * slow[i];
  }
  return y;
}

// Adds to the first bins of a motion.
void add_slow(const FusedRecord& f, const Spectrum& slow, DofMotion& m) {
  const auto series = [&](int quantity) {
    Spectrum s = Spectrum::Zero(f.fourier->bins());
    for (Eigen::Index i = 0; i < slow.size(); ++i) s[i] = slow[i] * derivative(f.omega(i), quantity);
    return f.fourier->inverse(s);
  };
  m.smooth_x += series(0), m.smooth_v += series(1), m.smooth_a += series(2);
}

}  // namespace

void add_slow_motion(FusedRecord& f, const System& system, const std::vector<ActiveTerm>& model, size_t record) {
  if (f.first_bin == 0) return;
  const Dynamics linear(system, model, Dynamics::Others::kNone);
  if (!held_in_place(linear)) return;
  const Eigen::Index n = static_cast<Eigen::Index>(system.dofs());
  std::vector<ActiveTerm> others;
  for (const ActiveTerm& t : model)
    if (!is_linear(t.term.kind)) others.push_back(t);
  const Eigen::Index top = std::min(kTop * f.first_bin, f.last_bin);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<LinkMotion> links;
    for (size_t l = 0; l < system.links.size(); ++l) links.push_back(link_motion(system, f, l));
    for (ActiveTerm& t : others) {
      const auto force = std::make_shared<std::vector<Series>>(record + 1);
      force->back() = term_force(t.term, f, links);
      t.force = force;
    }
    const Eigen::MatrixXd push = imbalance(system, f, others, record, false);
    Eigen::MatrixXcd slow(top, n);
    for (Eigen::Index j = 0; j < n; ++j)
      slow.col(j) = f.fourier->forward(push.col(j), top);  // not windowed: a mean stays a mean
    for (Eigen::Index i = 0; i < top; ++i)
      slow.row(i) = force_per_motion(linear, f.omega(i)).partialPivLu().solve(slow.row(i).transpose()).transpose();
    for (Eigen::Index j = 0; j < n; ++j) {
      DofMotion& m = f.motion[static_cast<size_t>(j)];
      if (!f.spectra[static_cast<size_t>(j)].measured[0])
        add_slow(f, completed(f, m, slow.col(j)) - f.fourier->forward(m.smooth_x, top), m);
    }
  }
}

}  // namespace diagnosis

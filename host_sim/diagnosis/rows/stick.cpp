// Near a velocity reversal the friction of a link is uncertain: the sign of the rate is not known, or the link sticks
// and its friction is whatever holds it. There the friction is estimated from the balance of forces, weighed against
// what Coulomb's law says of it; what stays uncertain is added to the covariance of the rows.
#include <algorithm>
#include <cmath>

#include "../record/sharpen.hpp"

namespace diagnosis {
namespace {

constexpr double kNarrow = 0.125, kWide = 2;  // in changes of the rate per sample that friction makes at a reversal
constexpr double kTrust = 9;  // stuck friction leans one way: a shrunken estimate of it would look like a spring

// Averaged over five samples: the rows end at a tenth of the sampling rate.
Eigen::MatrixXd averaged(const Eigen::MatrixXd& e) {
  Eigen::MatrixXd mean = e;
  for (Eigen::Index i = 2; i + 2 < e.rows(); ++i)
    mean.row(i) = 0.2 * (e.row(i - 2) + e.row(i - 1) + e.row(i) + e.row(i + 1) + e.row(i + 2));
  return mean;
}

double inverse_mass(const std::vector<ActiveTerm>& model, int end) {
  double mass = 0;
  for (const ActiveTerm& t : model)
    if (t.term.dof == end - 1 && t.term.kind == Kind::kMass) mass += t.value;
  return end > 0 && mass > 0 ? 1 / mass : 0;
}

// Friction level of each link, zero where it has none.
std::vector<double> friction_levels(const System& s, const std::vector<ActiveTerm>& model) {
  std::vector<double> level(s.links.size(), 0.0);
  for (const ActiveTerm& t : model) {
    const Kind kind = t.term.kind;
    if (kind == Kind::kCoulomb || kind == Kind::kMissingCoulomb || kind == Kind::kStribeck)
      level[static_cast<size_t>(t.term.link)] += t.value;
  }
  for (double& l : level) l = std::max(l, 0.0);
  return level;
}

}  // namespace

void Rows::hold_stuck(const std::vector<ActiveTerm>& model) {
  const std::vector<double> level = friction_levels(system_, model);
  const double reach = reversals_ == Reversals::kWide ? kWide : kNarrow;
  absorbed_ = 0;
  for (size_t r = 0; r < records_.size(); ++r) {
    const FusedRecord& f = records_[r];
    doubt_[r].assign(level.size(), 0.0);
    for (auto& spectrum : held_[r]) spectrum.resize(0);
    if (std::all_of(level.begin(), level.end(), [](double v) { return v <= 0; })) continue;
    Eigen::MatrixXd e = averaged(imbalance(system_, f, model, r, false));
    const Eigen::VectorXd variance = ((e.cwiseAbs2().transpose() * f.inner) / f.inner.sum()).cwiseMax(1e-300);
    for (size_t l = 0; l < level.size(); ++l) {
      if (level[l] <= 0) continue;
      const int a = system_.links[l].a - 1, b = system_.links[l].b - 1;
      const double trust_a = a >= 0 ? 1 / variance[a] : 0, trust_b = b >= 0 ? 1 / variance[b] : 0;
      const double noise = 1 / (trust_a + trust_b);
      const LinkMotion& m = links_[r][l];
      const double jump = 2 * level[l] * (inverse_mass(model, a + 1) + inverse_mass(model, b + 1)) * f.period_s;
      const double spread = std::min(std::max(m.w_error, reach * jump), 0.1 * m.w_rms);
      Series held = Series::Zero(static_cast<Eigen::Index>(f.samples));
      double doubt = 0;
      for (Eigen::Index i = 0; i < held.size(); ++i) {
        if (f.inner[i] <= 0 || std::abs(m.smooth_w[i]) > 4 * spread) continue;
        const double sign = std::erf(m.smooth_w[i] / (1.4142135623730951 * spread));
        const double prior = level[l] * level[l] * (1 - sign * sign), keep = kTrust * prior / (kTrust * prior + noise);
        const double balance = noise * ((a >= 0 ? trust_a * e(i, a) : 0) - (b >= 0 ? trust_b * e(i, b) : 0));
        held[i] = keep * balance;
        absorbed_ += keep * f.inner[i] * 2 * static_cast<double>(f.last_bin) / static_cast<double>(f.samples);
        doubt += f.inner[i] * f.inner[i] * ((1 - keep) * (1 - keep) * prior + 2 * keep * keep * noise);
        if (a >= 0) e(i, a) -= held[i];
        if (b >= 0) e(i, b) += held[i];
      }
      held_[r][l] = row_spectrum(f, held);
      doubt_[r][l] = doubt / f.inner_energy;
    }
  }
}

}  // namespace diagnosis

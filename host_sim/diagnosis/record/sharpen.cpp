#include "sharpen.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {

Eigen::MatrixXd imbalance(const System& s, const FusedRecord& f, const std::vector<ActiveTerm>& model, size_t record,
                          bool without_mass) {
  Eigen::MatrixXd e = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(f.samples), static_cast<Eigen::Index>(s.dofs()));
  for (size_t j = 0; j < s.dofs(); ++j)
    if (f.force[j].size()) e.col(static_cast<Eigen::Index>(j)) = f.force[j];
  for (const ActiveTerm& t : model) {
    const Term& term = t.term;
    if (term.dof >= 0) {
      const bool mass = term.kind == Kind::kMass || term.kind == Kind::kMassError;
      if (!(mass && without_mass)) e.col(term.dof) -= t.value * (*t.force)[record];
      continue;
    }
    const rig_file::Link& l = s.links[static_cast<size_t>(term.link)];
    if (l.a > 0) e.col(l.a - 1) -= t.value * (*t.force)[record];
    if (l.b > 0) e.col(l.b - 1) += t.value * (*t.force)[record];
  }
  return e;
}

void sharpen(std::vector<FusedRecord>& records, const System& system, const std::vector<ActiveTerm>& model) {
  for (size_t r = 0; r < records.size(); ++r) {
    FusedRecord& f = records[r];
    const Eigen::MatrixXd force = imbalance(system, f, model, r, true);
    for (size_t j = 0; j < system.dofs(); ++j) {
      DofMotion& m = f.motion[j];
      double mass = 0;
      for (const ActiveTerm& t : model) {
        const Term& term = t.term;
        if (term.dof == static_cast<int>(j) && (term.kind == Kind::kMass || term.kind == Kind::kMassError))
          mass += t.value;
      }
      if (!(mass > 0) || m.raw.size() == 0) continue;
      const Spectrum push =
          f.fourier->forward(f.outer.weight.cwiseProduct(force.col(static_cast<Eigen::Index>(j))) / mass);
      Spectrum y(m.raw.size());
      const double low = 0.01 * static_cast<double>(f.samples), high = 0.02 * static_cast<double>(f.samples);
      for (Eigen::Index i = 0; i < y.size(); ++i) {
        const double share = std::clamp((static_cast<double>(i) - low) / (high - low), 0.0, 1.0) * (1 - m.trust[i]);
        y[i] = m.trust[i] * m.raw[i];
        if (share > 0) y[i] += share * push[i] / derivative(f.omega(i), 2);
      }
      Spectrum d(y.size());
      const auto series = [&](int quantity) {
        for (Eigen::Index i = 0; i < y.size(); ++i) d[i] = y[i] * derivative(f.omega(i), quantity);
        return f.fourier->inverse(d);
      };
      m.smooth_x = series(0), m.smooth_v = series(1), m.smooth_a = series(2);
    }
    add_slow_motion(f, system, model, r);
  }
}

}  // namespace diagnosis

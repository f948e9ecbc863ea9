// Columns of the rows: forces of terms, and what the measured force leaves for them.
#include "rows.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {

Spectrum row_spectrum(const FusedRecord& f, const Series& force) {
  return f.fourier->forward(f.inner.cwiseProduct(force), f.last_bin + 1).tail(f.last_bin + 1 - f.first_bin);
}

Rows::Rows(const System& system, const std::vector<FusedRecord>& records) : system_(system), records_(records) {
  for (const FusedRecord& f : records) {
    links_.emplace_back();
    for (size_t l = 0; l < system.links.size(); ++l) links_.back().push_back(link_motion(system, f, l));
    force_.emplace_back();
    for (const Series& force : f.force) force_.back().push_back(force.size() ? row_spectrum(f, force) : Spectrum());
    held_.emplace_back(system.links.size());
    doubt_.emplace_back(system.links.size(), 0.0);
    size_ += 2 * static_cast<Eigen::Index>(system.dofs()) * (f.last_bin + 1 - f.first_bin);
  }
}

bool Rows::has_force(size_t dof) const {
  for (const auto& record : force_)
    if (record[dof].size() == 0) return false;
  return true;
}

bool Rows::absolute() const {
  return std::all_of(records_.begin(), records_.end(), [](const FusedRecord& f) { return f.first_bin == 0; });
}

bool Rows::coarse() const {
  return std::any_of(records_.begin(), records_.end(), [](const FusedRecord& f) { return f.coarse; });
}

bool Rows::redundant() const {
  for (const FusedRecord& f : records_)
    for (size_t j = 0; j < system_.dofs(); ++j)
      if (f.spectra[j].count() < 2) return false;
  return true;
}

Series Rows::force_of(const Term& term, size_t record) const {
  if (term.record >= 0 && term.record != static_cast<int>(record))
    return Series::Zero(static_cast<Eigen::Index>(records_[record].samples));
  return term_force(term, records_[record], links_[record]);
}

void Rows::prepare(ActiveTerm& t) const {
  if (t.force) return;
  const auto force = std::make_shared<std::vector<Series>>();
  for (size_t r = 0; r < records_.size(); ++r) force->push_back(force_of(t.term, r));
  t.force = force;
}

std::shared_ptr<const Column> Rows::column(const Term& term) const {
  const auto column = std::make_shared<Column>();
  Column& c = *column;
  c.term = term;
  double ku = 0, uu = 1e-300, cw = 0, ww = 1e-300, ma = 0, aa = 1e-300;
  for (size_t r = 0; r < records_.size(); ++r) {
    const FusedRecord& f = records_[r];
    const Series force = force_of(term, r);
    c.spectra.push_back(row_spectrum(f, force));
    const Series weighted = f.inner.cwiseAbs2().cwiseProduct(force);
    if (term.link >= 0) {
      const LinkMotion& l = links_[r][static_cast<size_t>(term.link)];
      ku += weighted.dot(l.smooth_u), uu += l.u_rms * l.u_rms * f.inner_energy;
      cw += weighted.dot(l.smooth_w), ww += l.w_rms * l.w_rms * f.inner_energy;
    } else if (term.kind == Kind::kMass || term.kind == Kind::kMassError || term.kind == Kind::kResonance) {
      const Series& a = f.motion[static_cast<size_t>(term.dof)].a;
      ma += weighted.dot(a), aa += f.inner.cwiseAbs2().dot(a.cwiseAbs2());
    }
  }
  c.stiffness = ku / uu, c.viscous = cw / ww, c.mass = ma / aa;
  if (term.kind == Kind::kMass || term.kind == Kind::kMassError) c.mass = 1;
  if (term.kind == Kind::kViscous || term.kind == Kind::kMissingViscous) c.viscous = 1, c.stiffness = 0;
  if (term.kind == Kind::kStiffness || term.kind == Kind::kStiffnessError) c.stiffness = 1, c.viscous = 0;
  return column;
}

std::vector<Balance> Rows::force() const {
  std::vector<Balance> list;
  for (size_t r = 0; r < records_.size(); ++r) {
    list.emplace_back(Balance::Zero(bins(r), static_cast<Eigen::Index>(system_.dofs())));
    for (size_t j = 0; j < system_.dofs(); ++j)
      if (force_[r][j].size()) list.back().col(static_cast<Eigen::Index>(j)) += force_[r][j];
    for (size_t l = 0; l < held_[r].size(); ++l)
      if (held_[r][l].size()) act(list.back(), place_of_link(system_, l), held_[r][l], -1);
  }
  return list;
}

std::vector<Tone> Rows::loudest_tones(const std::vector<Balance>& residual) const {
  std::vector<Tone> list;
  for (size_t r = 0; r < records_.size(); ++r) {
    const FusedRecord& f = records_[r];
    for (int j = 0; j < static_cast<int>(system_.dofs()); ++j) {
      const Information& information = (*weights_)[r];
      const Spectrum pulled = information.pulled({j, -1}, residual[r]);
      const Series weight = information.weight({j, -1});
      Tone best;
      for (Eigen::Index i = 0; i < pulled.size(); ++i) {
        const double hertz = f.omega(i + f.first_bin) / 6.283185307179586, gain = std::norm(pulled[i]) / weight[i];
        if (hertz >= 1 && gain > best.gain) best = {hertz, gain, j};
      }
      list.push_back(best);
    }
  }
  return list;
}

}  // namespace diagnosis

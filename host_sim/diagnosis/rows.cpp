#include "rows.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

using Matrix = Eigen::MatrixXcd;

// Sampling, smoothing and the reversals of friction leave this share of a link's damping force wrong, noise or not.
constexpr double kKnownDamping = 0.006;

// Incidence of a link (or a DOF) over the DOFs.
Eigen::VectorXd incidence(const System& s, size_t index) {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s.dofs()));
  if (index >= s.links.size()) {
    b[static_cast<Eigen::Index>(index - s.links.size())] = 1;
    return b;
  }
  if (s.links[index].a > 0) b[s.links[index].a - 1] += 1;
  if (s.links[index].b > 0) b[s.links[index].b - 1] -= 1;
  return b;
}

}  // namespace

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
    inflation_.push_back(Series::Ones(f.last_bin + 1 - f.first_bin));
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

Column Rows::column(const Term& term) const {
  Column c;
  c.term = term;
  double ku = 0, uu = 1e-300, cw = 0, ww = 1e-300, ma = 0, aa = 1e-300;
  for (size_t r = 0; r < records_.size(); ++r) {
    const FusedRecord& f = records_[r];
    Series force = term_force(term, f, links_[r]);
    if (term.record >= 0 && term.record != static_cast<int>(r)) force.setZero();
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
  return c;
}

void Rows::weight(const std::vector<ActiveTerm>& model) {
  const Eigen::Index n = static_cast<Eigen::Index>(system_.dofs());
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n), stiffness = mass, viscous = mass;
  struct Damping {
    double viscous = 0, friction = 0;
    double operator()(const LinkMotion& m) const { return std::hypot(viscous * m.w_rms, friction); }
  };
  std::vector<Damping> damping(system_.links.size());
  for (const ActiveTerm& t : model) {
    const Term& term = t.column.term;
    const double value = t.host >= 0 ? t.host_sign * model[static_cast<size_t>(t.host)].value : t.value;
    if (term.link >= 0) {
      if (term.kind == Kind::kViscous || term.kind == Kind::kMissingViscous) damping[static_cast<size_t>(term.link)].viscous += value;
      if (term.kind == Kind::kCoulomb || term.kind == Kind::kMissingCoulomb) damping[static_cast<size_t>(term.link)].friction += value;
      const Eigen::VectorXd b = incidence(system_, static_cast<size_t>(term.link));
      stiffness += value * t.column.stiffness * b * b.transpose();
      viscous += value * t.column.viscous * b * b.transpose();
    } else if (term.dof >= 0) {
      mass(term.dof, term.dof) += value * t.column.mass;
    }
  }
  patterns_.clear();
  for (size_t r = 0; r < records_.size(); ++r) {
    const FusedRecord& f = records_[r];
    const Eigen::Index bins = f.last_bin + 1 - f.first_bin;
    const size_t count = system_.links.size() + system_.dofs();
    std::vector<Matrix> sigma(static_cast<size_t>(bins));
    Matrix d(n, n), friction = Matrix::Zero(n, n);
    for (size_t l = 0; l < system_.links.size(); ++l) {
      const Eigen::VectorXd b = incidence(system_, l);
      const double floor = std::pow(kKnownDamping * damping[l](links_[r][l]), 2) * static_cast<double>(f.samples) / (2.0 * static_cast<double>(f.last_bin));
      friction += ((doubt_[r][l] + floor) * b * b.transpose()).cast<Complex>();
    }
    for (Eigen::Index i = 0; i < bins; ++i) {
      const double omega = f.omega(i + f.first_bin);
      d = (stiffness - omega * omega * mass).cast<Complex>() + Complex(0, omega) * viscous.cast<Complex>();
      Matrix& s = sigma[static_cast<size_t>(i)];
      s = friction;
      for (Eigen::Index j = 0; j < n; ++j) {
        s += f.motion[static_cast<size_t>(j)].variance[i + f.first_bin] * d.col(j) * d.col(j).adjoint();
        if (f.force_noise[static_cast<size_t>(j)].size())
          s(j, j) += f.force_noise[static_cast<size_t>(j)][i + f.first_bin];
      }
    }
    // the weight's spectrum is a few bins wide: so is what noise reaches
    constexpr Eigen::Index kReach = 2;
    patterns_.emplace_back(count, Matrix::Zero(n, bins));
    std::vector<Eigen::VectorXcd> incidences;
    for (size_t p = 0; p < count; ++p) incidences.push_back(incidence(system_, p).cast<Complex>());
    for (Eigen::Index i = 0; i < bins; ++i) {
      Matrix s = Matrix::Zero(n, n);
      double weights = 0;
      for (Eigen::Index k = -kReach; k <= kReach; ++k) {
        if (i + k < 0 || i + k >= bins) continue;
        const double w = k == 0 ? 0.6 : 0.1;
        s += w * sigma[static_cast<size_t>(i + k)];
        weights += w;
      }
      s *= inflation_[r][i] * f.inner_energy / (2 * weights);
      s.diagonal().array() += 1e-12 * s.diagonal().real().sum() + 1e-280;
      const Eigen::LLT<Matrix> cholesky(s);
      for (size_t p = 0; p < count; ++p) patterns_.back()[p].col(i) = cholesky.matrixL().solve(incidences[p]);
    }
  }
}

void Rows::colour(const Series& residual, double freedom) {
  Eigen::Index offset = 0;
  const Eigen::Index n = static_cast<Eigen::Index>(system_.dofs());
  for (Series& factor : inflation_) {
    const Eigen::Index bins = factor.size();
    Series total(bins + 1);
    total[0] = 0;
    for (Eigen::Index i = 0; i < bins; ++i)
      total[i + 1] = total[i] + factor[i] * residual.segment(offset + 2 * i * n, 2 * n).squaredNorm() / (2.0 * static_cast<double>(n));
    for (Eigen::Index i = 0; i < bins; ++i) {
      const Eigen::Index reach = 6 + i / 8, low = std::max<Eigen::Index>(0, i - reach), high = std::min(bins, i + reach + 1);
      factor[i] = std::max(1.0, (total[high] - total[low]) / static_cast<double>(high - low) / freedom);
    }
    offset += 2 * n * bins;
  }
}

void Rows::place(const Matrix& pattern, const Spectrum& spectrum, Eigen::Index offset, Series& out) const {
  const Eigen::Index n = pattern.rows();
  for (Eigen::Index i = 0; i < spectrum.size(); ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const Complex value = pattern(j, i) * spectrum[i];
      out[offset + 2 * (i * n + j)] += value.real();
      out[offset + 2 * (i * n + j) + 1] += value.imag();
    }
}

Series Rows::whitened(const Column& c) const {
  Series out = Series::Zero(size_);
  const size_t pattern = c.term.link >= 0 ? static_cast<size_t>(c.term.link)
                                          : system_.links.size() + static_cast<size_t>(c.term.dof);
  Eigen::Index offset = 0;
  for (size_t r = 0; r < records_.size(); ++r) {
    place(patterns_[r][pattern], c.spectra[r], offset, out);
    offset += 2 * static_cast<Eigen::Index>(system_.dofs()) * c.spectra[r].size();
  }
  return out;
}

std::vector<Tone> Rows::loudest_tones(const Series& residual) const {
  std::vector<Tone> list;
  Eigen::Index offset = 0;
  const Eigen::Index n = static_cast<Eigen::Index>(system_.dofs());
  for (size_t r = 0; r < records_.size(); ++r) {
    const FusedRecord& f = records_[r];
    for (Eigen::Index j = 0; j < n; ++j) {
      Tone best;
      const Matrix& pattern = patterns_[r][system_.links.size() + static_cast<size_t>(j)];
      for (Eigen::Index i = 0; i < pattern.cols(); ++i) {
        if (f.omega(i + f.first_bin) < 6.283) continue;
        Complex sum = 0;
        for (Eigen::Index k = 0; k < n; ++k)
          sum += std::conj(pattern(k, i)) * Complex(residual[offset + 2 * (i * n + k)], residual[offset + 2 * (i * n + k) + 1]);
        const double gain = std::norm(sum) / pattern.col(i).squaredNorm();
        if (gain > best.gain) best = {f.omega(i + f.first_bin) / 6.283185307179586, gain, static_cast<int>(j)};
      }
      list.push_back(best);
    }
    offset += 2 * n * (f.last_bin + 1 - f.first_bin);
  }
  return list;
}

Series Rows::whitened_force() const {
  Series out = Series::Zero(size_);
  Eigen::Index offset = 0;
  for (size_t r = 0; r < records_.size(); ++r) {
    for (size_t j = 0; j < system_.dofs(); ++j)
      if (force_[r][j].size()) place(patterns_[r][system_.links.size() + j], force_[r][j], offset, out);
    for (size_t l = 0; l < held_[r].size(); ++l)
      if (held_[r][l].size()) place(patterns_[r][l], -held_[r][l], offset, out);
    offset += 2 * static_cast<Eigen::Index>(system_.dofs()) * (records_[r].last_bin + 1 - records_[r].first_bin);
  }
  return out;
}

}  // namespace diagnosis

// How far a free run is from the record.
#include <algorithm>
#include <cmath>

#include "../record/sharpen.hpp"
#include "free_run.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace diagnosis {
namespace {

constexpr double kWorst = 1e6;  // what a run that fails to stay finite scores, %

double variance(const Series& s) { return (s.array() - s.mean()).square().mean(); }

bool massless(const std::vector<ActiveTerm>& model, size_t dof) {
  for (const ActiveTerm& t : model)
    if (t.term.kind == Kind::kMass && t.term.dof == static_cast<int>(dof) && t.value > 0) return false;
  return true;
}

// Of a displacement that is integrated from other channels what its noise leaves: each frequency by its trust.
Series trusted(const FusedRecord& f, const DofMotion& m, Eigen::Index from, const Series& s) {
  Series whole = Series::Zero(static_cast<Eigen::Index>(f.samples));
  whole.segment(from, s.size()) = s;
  return f.fourier->inverse(f.fourier->forward(whole).cwiseProduct(m.trust)).segment(from, s.size());
}

Eigen::MatrixXd force_errors(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& f,
                             Eigen::Index from, Eigen::Index to) {
  std::vector<ActiveTerm> prepared = model;
  std::vector<LinkMotion> links;
  for (size_t l = 0; l < system.links.size(); ++l) links.push_back(link_motion(system, f, l));
  for (ActiveTerm& t : prepared) t.force = std::make_shared<std::vector<Series>>(1, term_force(t.term, f, links));
  return imbalance(system, f, prepared, 0, false).middleRows(from, to - from);
}

double force_variance(const FusedRecord& f, size_t dof, Eigen::Index from, Eigen::Index to) {
  return std::max(f.force[dof].size() ? variance(f.force[dof].segment(from, to - from)) : 0, 1e-300);
}

HoldoutScore score_force(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& f,
                         Eigen::Index from, Eigen::Index to) {
  HoldoutScore score;
  const Eigen::MatrixXd e = force_errors(system, model, f, from, to);
  for (size_t j = 0; j < system.dofs(); ++j) {
    const double ratio = e.col(static_cast<Eigen::Index>(j)).squaredNorm() / static_cast<double>(to - from) /
                         force_variance(f, j, from, to);
    score.nrmse_percent.push_back(100 * std::sqrt(ratio)), score.velocity_percent.push_back(100 * std::sqrt(ratio));
    score.mse_percent.push_back(100 * ratio);
  }
  return score;
}

bool any_massless(const System& system, const std::vector<ActiveTerm>& model) {
  for (size_t j = 0; j < system.dofs(); ++j)
    if (massless(model, j)) return true;
  return false;
}

Eigen::Index span_of(const System& system, const FusedRecord& f, Eigen::Index whole) {
  return vocabulary::held_in_place(system.rig) ? whole : std::max<Eigen::Index>(2, std::lround(1 / f.period_s));
}

}  // namespace

Series run_errors(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& f, Eigen::Index from,
                  Eigen::Index to, int steps) {
  const Eigen::Index n = static_cast<Eigen::Index>(system.dofs()), length = to - from;
  Series errors = Series::Zero(n * length);
  if (any_massless(system, model)) {
    const Eigen::MatrixXd e = force_errors(system, model, f, from, to);
    for (Eigen::Index j = 0; j < n; ++j)
      errors.segment(j * length, length) = e.col(j) / std::sqrt(force_variance(f, static_cast<size_t>(j), from, to));
    return errors;
  }
  const Eigen::Index span = span_of(system, f, length);
  for (Eigen::Index start = from; start + 2 <= to; start += span) {
    const Eigen::Index end = std::min(start + span, to);
    const FreeRun run = free_run(system, model, f, start, end, steps);
    if (!run.finite) return Series();
    for (Eigen::Index j = 0; j < n; ++j) {
      const DofMotion& m = f.motion[static_cast<size_t>(j)];
      errors.segment(j * length + start - from, end - start) =
          (run.x[static_cast<size_t>(j)] - m.x.segment(start, end - start)) /
          std::sqrt(std::max(variance(m.x.segment(from, length)), 1e-300));
    }
  }
  return errors;
}

HoldoutScore score_free_run(const System& system, const std::vector<ActiveTerm>& model, const FusedRecord& f,
                            Eigen::Index from, Eigen::Index to) {
  if (any_massless(system, model)) return score_force(system, model, f, from, to);
  const size_t n = system.dofs();
  std::vector<double> x(n), v(n), a(n);  // squared errors
  bool finite = true;
  const Eigen::Index span = span_of(system, f, to - from);
  Eigen::Index start = from;
  const auto told = [&](size_t dof, Eigen::Index first, const Series& s) {
    return f.spectra[dof].measured[0] ? s : trusted(f, f.motion[dof], first, s);
  };
  for (; start + 2 <= to; start += span) {
    const Eigen::Index end = std::min(start + span, to);
    const FreeRun run = free_run(system, model, f, start, end);
    finite = finite && run.finite;
    for (size_t j = 0; j < n; ++j) {
      const DofMotion& m = f.motion[j];
      x[j] += told(j, start, run.x[j] - m.x.segment(start, end - start)).squaredNorm();
      v[j] += (run.v[j] - m.v.segment(start, end - start)).squaredNorm();
      a[j] += (run.a[j] - m.a.segment(start, end - start)).squaredNorm();
    }
  }
  HoldoutScore score;
  const double samples = static_cast<double>(std::min(start, to) - from);
  const auto share = [&](double error, const Series& s) {
    return finite ? error / samples / std::max(variance(s.segment(from, to - from)), 1e-300) : kWorst;
  };
  for (size_t j = 0; j < n; ++j) {
    const DofMotion& m = f.motion[j];
    score.nrmse_percent.push_back(std::min(kWorst, 100 * std::sqrt(share(x[j], told(j, 0, m.x)))));
    score.velocity_percent.push_back(std::min(kWorst, 100 * std::sqrt(share(v[j], m.v))));
    score.mse_percent.push_back(std::min(kWorst, 100 * share(a[j], m.a)));
  }
  return score;
}

}  // namespace diagnosis

#include "unresolved_mode.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "../record/motion.hpp"
#include "firmware/vocabulary/effect_table.hpp"
#include "host_sim/response/linear_rig.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kOpposed = 0.5;  // of a beat: from there on the amplitude comes back, which no damping makes it do

// Masses, and springs about the rest, of a model; the last node is what it hides.
struct Undamped {
  Mat mass, spring;
};

Undamped undamped(const System& system, const Model& model, const ModelTerm& hidden) {
  const Index n = static_cast<Index>(system.dofs());
  Undamped rig{Mat::Zero(n + 1, n + 1), Mat::Zero(n + 1, n + 1)};
  for (const ModelTerm& t : model) {
    if (t.term.kind == Kind::kMass || (t.term.kind == Kind::kMassError && t.term.link < 0))
      rig.mass(t.term.dof, t.term.dof) += t.value;
    if (t.term.link < 0 || t.host >= 0 || !firmware::row_of(effect_of(t.term.kind)).nature.conservative) continue;
    const Place ends = place_of_force(system, t.term);
    host_sim::add_between(rig.spring, ends.plus, ends.minus,
                          t.value * law(t.term.kind, 0, 0, 0, t.term.shape, t.term.shape2).by_u);
  }
  rig.mass(n, n) = hidden.value;
  host_sim::add_between(rig.spring, hidden.term.dof, n, hidden.value * std::pow(kTwoPi * hidden.term.shape, 2));
  return rig;
}

const ModelTerm* hidden_in(const Model& model) {
  const auto hides = [](const ModelTerm& t) { return t.term.kind == Kind::kResonance; };
  const auto found = std::find_if(model.rbegin(), model.rend(), hides);
  return found == model.rend() ? nullptr : &*found;
}

}  // namespace

double split_Hz(const System& system, const Model& model) {
  const ModelTerm* hidden = hidden_in(model);
  if (!hidden || !(hidden->value > 0)) return 0;
  const Undamped rig = undamped(system, model, *hidden);
  if (!(rig.mass.diagonal().minCoeff() > 0)) return 0;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Mat> modes(rig.spring, rig.mass);
  if (modes.info() != Eigen::Success) return 0;
  const Index last = rig.mass.rows() - 1;
  const Vec part = modes.eigenvectors().row(last).array().square();
  Index most = 0, next = -1;
  part.maxCoeff(&most);
  for (Index i = 0; i < part.size(); ++i)
    if (i != most && (next < 0 || part[i] > part[next])) next = i;
  const auto hertz = [&](Index i) { return std::sqrt(std::max(0.0, modes.eigenvalues()[i])) / kTwoPi; };
  return next < 0 ? 0 : std::abs(hertz(most) - hertz(next));
}

double lasts_s(const Vec& motion, double step_s) {
  const double square = motion.squaredNorm(), fourth = motion.array().pow(4).sum();
  return fourth > 0 ? 1.5 * square * square / fourth * step_s : 0;
}

bool is_unresolved_mode(const Task& task, const State& with, const std::vector<Candidate>& added) {
  const auto hides = [](const Candidate& c) { return c.terms[0].kind == Kind::kResonance; };
  if (std::none_of(added.begin(), added.end(), hides) || forced(task.records) || task.records[0].base.given())
    return false;
  double longest_s = 0;
  for (const Prepared& p : task.records)
    for (size_t d = 0; d + 1 < p.guess.size(); ++d) longest_s = std::max(longest_s, lasts_s(p.guess[d].v, p.step_s));
  const double split = split_Hz(task.system, with.model);
  return split > 0 && split * longest_s < kOpposed;
}

}  // namespace diagnosis::runs

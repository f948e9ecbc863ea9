#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "host_sim/response/linear_rig.hpp"
#include "simulator.hpp"
#include "tangents.hpp"

// A model as lists of masses, elements and frictions between nodes.
namespace diagnosis::runs {
namespace {

constexpr double kTurnPerStep = 0.3;  // rad of the fastest mode: order 4 is then right to 1e-4 of a radian per radian
constexpr int kMostSubsteps = 8;
// Times a damper's rate, 1/s: a longer step of order 4 makes what it damps grow. Nothing is simulated then.
constexpr double kLongestStable = 2.785;
// Order 4 takes turn^5 / 144 of the amplitude per radian: a damping ratio that the rig does not have. Of a mode's own it may be a
// thousandth, a tenth of what long records tell a damper to; of a mode that linear dampers leave alone, of that of welded steel.
constexpr double kMostOfDamping = 1e-3, kOfOrderFour = 144, kLeastDampingRatio = 3e-4;

int node_of(int end) { return end > 0 ? end - 1 : end == rig_file::kBase ? -2 : -1; }

}  // namespace

Simulator::Simulator(const System& system, const Model& model, const Prepared& record) : record_(record) {
  compile(system, model);
  double fastest = 0, damped = 0;
  if (!massless_) {
    for (Index i = 0; i < nodes_; ++i) sound_ = sound_ && mass_[i] > 0 && std::isfinite(mass_[i]);
    Vec stiff = Vec::Zero(nodes_), drag = Vec::Zero(nodes_);
    for (const Element& e : elements_) {
      double k = 0, c = 0;
      if (e.kind == Kind::kStiffness || e.kind == Kind::kStiffnessError || e.kind == Kind::kGravity ||
          e.kind == Kind::kEndStop)
        k = std::abs(e.value);
      if (e.kind == Kind::kPresliding) k = std::abs(e.value) / e.shape, c = 2 * k * e.shape2;  // as they turn over
      if (e.kind == Kind::kViscous || e.kind == Kind::kMissingViscous) c = std::abs(e.value);
      if (is_curve(e.kind)) {
        const LawValue most = steepest(e.kind, e.shape, e.shape2, record, e.a, e.b);
        k = std::max(k, std::abs(e.value) * most.by_u), c = std::abs(e.value) * most.by_w;
      }
      for (int end : {e.a, e.b})
        if (end >= 0) stiff[end] += k, drag[end] += c;
    }
    for (Index i = 0; sound_ && i < nodes_; ++i) {
      damped = std::max(damped, drag[i] / mass_[i]);
      fastest = std::max({fastest, std::sqrt(stiff[i] / mass_[i]) * (nodes_ > 1 ? 1.2 : 1.0), damped});
    }
  }
  const double rate = std::max(fastest / kTurnPerStep, massless_ || !sound_ ? 0.0 : steps_per_second());
  substeps_ = std::clamp(static_cast<int>(std::ceil(rate * record.step_s)), 1, kMostSubsteps);
  sound_ = sound_ && damped * record.step_s / substeps_ < kLongestStable;
  late_ = record.held && record.step_s > 1.5 * record.read_every_s, steps_ = record.held && !late_;
  if (massless_) return;
  upsample(model);
  affine_ = all_lines();
}

// So many that no mode of the springs and dampers is damped by the steps.
double Simulator::steps_per_second() const {
  Mat stiffness = Mat::Zero(nodes_, nodes_), damping = stiffness;
  for (const Element& e : elements_) {
    const bool resonance = e.kind == Kind::kResonance;
    if (!resonance && !e.linear) continue;
    const double omega = kTwoPi * e.shape;
    const double k = e.value * (resonance ? omega * omega : e.by_u),
                 c = e.value * (resonance ? 2 * e.shape2 * omega : e.by_w);
    host_sim::add_between(stiffness, e.a, e.b, k), host_sim::add_between(damping, e.a, e.b, c);
  }
  const Vec root = mass_.cwiseInverse().cwiseSqrt();
  const Eigen::SelfAdjointEigenSolver<Mat> modes(root.asDiagonal() * stiffness * root.asDiagonal());
  double most = 0;
  for (Index i = 0; i < nodes_; ++i) {
    if (!(modes.eigenvalues()[i] > 0)) continue;
    const double omega = std::sqrt(modes.eigenvalues()[i]);
    const Vec shape = root.cwiseProduct(modes.eigenvectors().col(i));
    const double ratio = std::max(shape.dot(damping * shape) / (2 * omega), kLeastDampingRatio);
    most = std::max(most, omega / std::pow(kOfOrderFour * kMostOfDamping * ratio, 0.2));
  }
  return most;
}

void Simulator::compile(const System& system, const Model& model) {
  const Index dofs = static_cast<Index>(system.dofs());
  nodes_ = dofs;
  for (const ModelTerm& t : model) nodes_ += t.term.kind == Kind::kResonance;
  mass_ = Vec::Zero(nodes_);
  by_mass_.resize(static_cast<size_t>(nodes_));
  for (const rig_file::Link& l : system.links) link_ends_.push_back({node_of(l.a), node_of(l.b)});
  const std::vector<Parameter> parameters = parameters_of(model);
  parameters_ = static_cast<Index>(parameters.size());
  const auto index_of = [&](size_t term, int shape) {
    for (size_t i = 0; i < parameters.size(); ++i)
      if (parameters[i].term == term && parameters[i].shape == shape) return static_cast<Index>(i);
    return Index{-1};
  };
  std::vector<bool> replaced(model.size(), false);
  for (const ModelTerm& t : model)
    if (t.host >= 0 && t.term.kind == Kind::kPresliding) replaced[static_cast<size_t>(t.host)] = true;
  Index hidden = dofs;
  for (size_t i = 0; i < model.size(); ++i) {
    const ModelTerm& t = model[i];
    const Kind kind = t.term.kind;
    const size_t coefficient = t.host >= 0 ? static_cast<size_t>(t.host) : i;
    const double value = model[coefficient].value;
    const Index by_value = index_of(coefficient, 0), by_shape = index_of(i, 1);
    if (kind == Kind::kMass || kind == Kind::kMassError) {
      mass_[t.term.dof] += value;
      if (by_value >= 0) by_mass_[static_cast<size_t>(t.term.dof)].push_back(by_value);
    } else if (kind == Kind::kResonance) {
      const int h = static_cast<int>(hidden++);
      mass_[h] = value;
      if (by_value >= 0) by_mass_[static_cast<size_t>(h)].push_back(by_value);
      elements_.push_back(
          {kind, t.term.dof, h, value, t.term.shape, t.term.shape2, by_value, by_shape, -1, index_of(i, 2)});
    } else if (t.term.link >= 0 && !replaced[i]) {
      const auto [a, b] = link_ends_[static_cast<size_t>(t.term.link)];
      Element e{kind, a, b, value, t.term.shape, t.term.shape2, by_value, by_shape, -1};
      e.by_shape2 = index_of(i, 2);
      e.linear = is_linear(kind);
      if (e.linear) e.by_u = law(kind, 0, 0, 0, 1, 0).by_u, e.by_w = law(kind, 0, 0, 0, 1, 0).by_w;
      if (kind == Kind::kPresliding) e.z = hysteresis_++;
      elements_.push_back(e);
      if (kind != Kind::kCoulomb && kind != Kind::kMissingCoulomb && kind != Kind::kStribeck) continue;
      auto f =
          std::find_if(friction_.begin(), friction_.end(), [&](const Friction& g) { return g.a == a && g.b == b; });
      if (f == friction_.end()) friction_.push_back({a, b, 1, {}}), f = friction_.end() - 1;
      f->levels.push_back(elements_.size() - 1);
    } else if (kind == Kind::kBaseDelay) {
      by_base_delay_ = by_value;
    } else if (of_force_sensor(kind)) {
      const auto dof = static_cast<size_t>(t.term.dof);
      faults_.push_back({kind, dof, t.term.shape, by_value, false, value});
      if (kind == Kind::kDeadBand && by_shape >= 0) faults_.push_back({kind, dof, t.term.shape, by_shape, true, value});
    }
  }
  massless_ = runs::massless(model);
  lightness_ = mass_.cwiseInverse();
}

}  // namespace diagnosis::runs

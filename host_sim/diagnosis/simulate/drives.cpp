#include <algorithm>
#include <cmath>

#include "../band/between_samples.hpp"
#include "simulator.hpp"

// What acts from outside, between the samples too: forces and the base.
namespace diagnosis::runs {

double Simulator::drive_at(const Vec& fine, double r) const {
  if (steps_) return fine[at_ / (2 * substeps_) * 2 * substeps_];
  const double f0 = fine[at_], f1 = fine[at_ + 1], f2 = fine[at_ + 2];
  return f0 + r * (-3 * f0 + 4 * f1 - f2) + r * r * (2 * f0 - 4 * f1 + 2 * f2);
}

// Outside::v alone.
double Simulator::base_rate(double r) const {
  if (!base_x_) return 0;
  const Vec& v = *base_v_;
  const double f0 = v[at_], f1 = v[at_ + 1], f2 = v[at_ + 2];
  return f0 + r * (-3 * f0 + 4 * f1 - f2) + r * r * (2 * f0 - 4 * f1 + 2 * f2);
}

// Two instants to a substep, of a channel that reads late.
Simulator::Fine Simulator::upsampled(const Vec& y, double late_s) const {
  return record_.between_samples->of(y, -late_s / record_.step_s, 2 * substeps_);
}

// Channels that read late: the base was there earlier.
void Simulator::upsample_base(const Model& model) {
  const Guess& base = record_.guess.back();
  if (!base.given) return;
  double late = 0;
  for (const ModelTerm& t : model)
    if (t.term.kind == Kind::kBaseDelay) late += t.value;
  const auto made = [&](const Vec& y) { return upsampled(y, late); };
  base_a_ = made(base.a);
  if (!record_.base.ridden) base_x_ = made(base.x), base_v_ = made(base.v);
  if (by_base_delay_ < 0) return;
  const double h = record_.step_s / (2 * substeps_);
  const Vec& acceleration = *base_a_;
  const Index n = acceleration.size();
  base_jerk_.resize(n);
  for (Index i = 0; i < n; ++i) {
    const Index a = std::max<Index>(0, i - 1), b = std::min(n - 1, i + 1);
    base_jerk_[i] = (acceleration[b] - acceleration[a]) / (static_cast<double>(b - a) * h);
  }
}

// Force and base; faults of a force's sensor are taken out of it.
void Simulator::upsample(const Model& model) {
  upsample_base(model);
  const Index count = (record_.samples - 1) * 2 * substeps_ + 1;
  std::vector<size_t> where(record_.force.size(), 0);
  for (size_t d = 0; d < record_.force.size(); ++d) {
    if (record_.force[d].size() == 0) continue;
    where[d] = fine_.size();
    fine_node_.push_back(static_cast<int>(d));
    double late = late_ ? -0.5 * record_.read_every_s : 0;
    for (const ModelTerm& t : model)
      if (t.term.kind == Kind::kForceDelay && t.term.dof == static_cast<int>(d)) late += t.value;
    // a channel that reads late: the true force came earlier
    fine_.push_back(upsampled(record_.force[d], late));
  }
  const double h = record_.step_s / (2 * substeps_);
  for (ForceFault& f : faults_) {
    const Vec& force = *fine_[f.fine = where[f.fine]];
    Vec slope(count);
    for (Index i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) * h;
      if (f.kind == Kind::kForceDelay)
        slope[i] =
            i + 2 < count && i > 1 ? (8 * (force[i + 1] - force[i - 1]) - (force[i + 2] - force[i - 2])) / (12 * h) : 0;
      else if (f.kind == Kind::kForceGain)
        slope[i] = -force[i];
      else if (f.of_width)
        slope[i] = std::abs(force[i]) < f.frequency ? 0 : -std::copysign(f.coefficient * f.frequency, force[i]);
      else if (f.kind == Kind::kDeadBand)
        slope[i] = -std::clamp(force[i], -f.frequency, f.frequency);
      else
        slope[i] =
            -(f.kind == Kind::kForceHumCos50 || f.kind == Kind::kForceHumCos60 ? std::cos(kTwoPi * f.frequency * t)
                                                                               : std::sin(kTwoPi * f.frequency * t));
    }
    fine_slope_.push_back(slope);
  }
  for (size_t i = 0; i < faults_.size(); ++i) {
    if (faults_[i].kind == Kind::kForceDelay || faults_[i].of_width) continue;
    for (const ModelTerm& t : model)
      if (t.term.kind == faults_[i].kind && t.term.dof == fine_node_[faults_[i].fine] &&
          t.term.shape == faults_[i].frequency)
        fine_[faults_[i].fine] = std::make_shared<const Vec>(*fine_[faults_[i].fine] + t.value * fine_slope_[i]);
  }
}

Simulator::Outside Simulator::outside(double r) const {
  Outside o;
  o.force = Vec::Zero(nodes_);
  const auto at = [&](const Vec& y) {
    const double f0 = y[at_], f1 = y[at_ + 1], f2 = y[at_ + 2];
    return f0 + r * (-3 * f0 + 4 * f1 - f2) + r * r * (2 * f0 - 4 * f1 + 2 * f2);
  };
  for (size_t i = 0; i < fine_.size(); ++i) o.force[fine_node_[i]] += drive_at(*fine_[i], r);
  if (base_x_) o.x = at(*base_x_), o.v = at(*base_v_), o.a = at(*base_a_);
  if (record_.base.ridden) o.carried = at(*base_a_);
  if (base_jerk_.size()) o.jerk = at(base_jerk_);
  o.t_s = (static_cast<double>(at_) / 2 + r) * record_.step_s / substeps_;
  return o;
}

}  // namespace diagnosis::runs

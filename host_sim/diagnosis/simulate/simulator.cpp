#include "simulator.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kTurnPerStep = 0.3;  // rad of the fastest mode: order 4 is then right to 1e-4 of a radian per radian
constexpr int kMostSubsteps = 8;
constexpr int kMostEvents = 12;

int node_of(int end) { return end > 0 ? end - 1 : end == rig_file::kBase ? -2 : -1; }

}  // namespace

Simulator::Simulator(const System& system, const Model& model, const Prepared& record) : record_(record) {
  compile(system, model);
  double fastest = 0;
  if (!massless_) {
    for (Index i = 0; i < nodes_; ++i) sound_ = sound_ && mass_[i] > 0 && std::isfinite(mass_[i]);
    Vec stiff = Vec::Zero(nodes_), drag = Vec::Zero(nodes_);
    for (const Element& e : elements_) {
      double k = 0, c = 0;
      if (e.kind == Kind::kStiffness || e.kind == Kind::kStiffnessError || e.kind == Kind::kGravity ||
          e.kind == Kind::kEndStop)
        k = std::abs(e.value);
      if (e.kind == Kind::kPresliding) k = std::abs(e.value) / e.shape;
      if (e.kind == Kind::kViscous || e.kind == Kind::kMissingViscous) c = std::abs(e.value);
      for (int end : {e.a, e.b})
        if (end >= 0) stiff[end] += k, drag[end] += c;
    }
    if (sound_)
      for (Index i = 0; i < nodes_; ++i)
        fastest = std::max({fastest, std::sqrt(stiff[i] / mass_[i]) * (nodes_ > 1 ? 1.2 : 1.0), drag[i] / mass_[i]});
  }
  substeps_ = std::clamp(static_cast<int>(std::ceil(fastest * record.step_s / kTurnPerStep)), 1, kMostSubsteps);
  if (!massless_) upsample(model);
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
      elements_.push_back({kind, t.term.dof, h, value, t.term.shape, t.term.shape2, by_value, by_shape, -1});
    } else if (t.term.link >= 0 && !replaced[i]) {
      const auto [a, b] = link_ends_[static_cast<size_t>(t.term.link)];
      Element e{kind, a, b, value, t.term.shape, t.term.shape2, by_value, by_shape, -1};
      e.by_phase = index_of(i, 2);
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
      faults_.push_back({kind, static_cast<size_t>(t.term.dof), t.term.shape, by_value});
    }
  }
  massless_ = runs::massless(model);
}

// Between samples, two instants to a substep.
Vec Simulator::finer(const Vec& y) const {
  const Index per = 2 * substeps_;
  Vec out((record_.samples - 1) * per + 1);
  for (Index k = 0; k < record_.samples; ++k)
    for (Index j = 0; j < (k + 1 < record_.samples ? per : 1); ++j)
      out[k * per + j] = j == 0 ? y[k] : between(y, k, static_cast<double>(j) / static_cast<double>(per));
  return out;
}

// Channels that read late: the base was there earlier.
void Simulator::upsample_base(const Model& model) {
  const Guess& base = record_.guess.back();
  if (!base.given) return;
  double late = 0;
  for (const ModelTerm& t : model)
    if (t.term.kind == Kind::kBaseDelay) late += t.value;
  const auto made = [&](const Vec& y) { return finer(late != 0 ? delayed(y, -late / record_.step_s) : y); };
  base_a_ = made(base.a);
  if (!record_.base.ridden) base_x_ = made(base.x), base_v_ = made(base.v);
  if (by_base_delay_ < 0) return;
  const double h = record_.step_s / (2 * substeps_);
  const Index n = base_a_.size();
  base_jerk_.resize(n);
  for (Index i = 0; i < n; ++i) {
    const Index a = std::max<Index>(0, i - 1), b = std::min(n - 1, i + 1);
    base_jerk_[i] = (base_a_[b] - base_a_[a]) / (static_cast<double>(b - a) * h);
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
    double late = 0;
    for (const ModelTerm& t : model)
      if (t.term.kind == Kind::kForceDelay && t.term.dof == static_cast<int>(d)) late += t.value;
    // a channel that reads late: the true force came earlier
    fine_.push_back(finer(late != 0 ? delayed(record_.force[d], -late / record_.step_s) : record_.force[d]));
  }
  const double h = record_.step_s / (2 * substeps_);
  for (ForceFault& f : faults_) {
    const Vec& force = fine_[f.fine = where[f.fine]];
    Vec slope(count);
    for (Index i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) * h;
      if (f.kind == Kind::kForceDelay)
        slope[i] =
            i + 2 < count && i > 1 ? (8 * (force[i + 1] - force[i - 1]) - (force[i + 2] - force[i - 2])) / (12 * h) : 0;
      else if (f.kind == Kind::kForceGain)
        slope[i] = -force[i];
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
    if (faults_[i].kind == Kind::kForceDelay) continue;
    for (const ModelTerm& t : model)
      if (t.term.kind == faults_[i].kind && t.term.dof == fine_node_[faults_[i].fine] &&
          t.term.shape == faults_[i].frequency)
        fine_[faults_[i].fine] += t.value * fine_slope_[i];
  }
}

Simulator::Outside Simulator::outside(double r) const {
  Outside o;
  o.force = Vec::Zero(nodes_);
  const auto at = [&](const Vec& y) {
    const double f0 = y[at_], f1 = y[at_ + 1], f2 = y[at_ + 2];
    return f0 + r * (-3 * f0 + 4 * f1 - f2) + r * r * (2 * f0 - 4 * f1 + 2 * f2);
  };
  for (size_t i = 0; i < fine_.size(); ++i) o.force[fine_node_[i]] += at(fine_[i]);
  if (base_x_.size()) o.x = at(base_x_), o.v = at(base_v_), o.a = at(base_a_);
  if (record_.base.ridden) o.carried = at(base_a_);
  if (base_jerk_.size()) o.jerk = at(base_jerk_);
  o.t_s = (static_cast<double>(at_) / 2 + r) * record_.step_s / substeps_;
  return o;
}

double Simulator::relative(const Vec& y, Index offset, int a, int b, double base) const {
  const auto end = [&](int i) { return i >= 0 ? y[offset + i] : i == -2 ? base : 0.0; };
  return end(a) - end(b);
}

double Simulator::level(const Friction& f, double w) const {
  double sum = 0;
  for (size_t i : f.levels) {
    const Element& e = elements_[i];
    sum += e.value * (e.kind == Kind::kStribeck ? std::exp(-std::abs(w) / e.shape) : 1.0);
  }
  return sum;
}

// Accelerations per force: the inverse of the masses, with stuck links as bodies.
void Simulator::renew_yield() {
  if (!yield_old_) return;
  yield_ = mass_.cwiseInverse().asDiagonal();
  held_.clear();
  for (const Friction& f : friction_)
    if (f.sign == 0) held_.push_back(&f);
  if (!held_.empty()) {
    Mat b = Mat::Zero(nodes_, static_cast<Index>(held_.size()));
    for (size_t i = 0; i < held_.size(); ++i) {
      if (held_[i]->a >= 0) b(held_[i]->a, static_cast<Index>(i)) += 1;
      if (held_[i]->b >= 0) b(held_[i]->b, static_cast<Index>(i)) -= 1;
    }
    const Mat mb = mass_.cwiseInverse().asDiagonal() * b;
    Mat inner = b.transpose() * mb;
    inner.diagonal().array() *= 1 + 1e-12;
    const auto solver = inner.ldlt();
    by_hold_ = solver.solve(mb.transpose());
    inner_inverse_ = solver.solve(Mat::Identity(inner.rows(), inner.cols()));
    yield_ -= mb * by_hold_;
  }
  yield_old_ = false;
}

// How the rates of stuck links would change if their DOFs stayed at rest, per unit of the base's acceleration, turned: what their
// DOFs must take part in.
Vec Simulator::with_base() const {
  Vec c = Vec::Zero(static_cast<Index>(held_.size()));
  for (size_t i = 0; i < held_.size(); ++i)
    c[static_cast<Index>(i)] = held_[i]->b == -2 ? 1 : held_[i]->a == -2 ? -1 : 0;
  return c;
}

void Simulator::accelerations(const Vec& y, const Outside& o, Vec& acc, bool slopes) {
  net_ = o.force;
  const Index columns = states() + parameters_;
  if (slopes) slope_x_.setZero(nodes_, columns);
  const auto add = [&](int node, Index column, double value) {
    if (node >= 0) slope_x_(node, column) += value;
  };
  const auto pull = [&](const Element& e, const LawValue& f) {
    const double force = e.value * f.force;
    if (e.a >= 0) net_[e.a] -= force;
    if (e.b >= 0) net_[e.b] += force;
    if (!slopes) return;
    const double ku = e.value * f.by_u, cw = e.value * f.by_w;
    for (int side = 0; side < 2; ++side) {
      const int node = side == 0 ? e.a : e.b, other = side == 0 ? e.b : e.a;
      if (node < 0) continue;
      slope_x_(node, node) -= ku, slope_x_(node, nodes_ + node) -= cw;
      if (other >= 0) slope_x_(node, other) += ku, slope_x_(node, nodes_ + other) += cw;
    }
    if (by_base_delay_ >= 0 && (e.a == -2 || e.b == -2))
      add(e.a >= 0 ? e.a : e.b, states() + by_base_delay_, ku * o.v + cw * o.a);
    if (e.by_value >= 0) add(e.a, states() + e.by_value, -f.force), add(e.b, states() + e.by_value, f.force);
    if (e.by_shape >= 0)
      add(e.a, states() + e.by_shape, -e.value * f.by_log_shape),
          add(e.b, states() + e.by_shape, e.value * f.by_log_shape);
    if (e.by_phase >= 0)
      add(e.a, states() + e.by_phase, -e.value * f.by_phase), add(e.b, states() + e.by_phase, e.value * f.by_phase);
  };
  for (const Element& e : elements_) {
    if (e.kind == Kind::kCoulomb || e.kind == Kind::kMissingCoulomb || e.kind == Kind::kStribeck) continue;
    const double u = relative(y, 0, e.a, e.b, o.x), w = relative(y, nodes_, e.a, e.b, o.v);
    if (e.kind == Kind::kPresliding) {
      const Index z = 2 * nodes_ + e.z;
      pull(e, {y[z], 0, 0, 0});
      if (slopes) add(e.a, z, -e.value), add(e.b, z, e.value);
      continue;
    }
    if (e.kind == Kind::kResonance) {
      const double omega = kTwoPi * e.shape;
      pull(e, {omega * omega * u + 2 * e.shape2 * omega * w, omega * omega, 2 * e.shape2 * omega,
               2 * omega * omega * u + 2 * e.shape2 * omega * w});
      continue;
    }
    const double time = law_time(o.t_s, e.shape, record_);
    pull(e, e.linear ? LawValue{e.by_u * u + e.by_w * w, e.by_u, e.by_w} : law(e.kind, u, w, time, e.shape, e.shape2));
  }
  for (const Friction& f : friction_) {
    if (f.sign == 0) continue;
    const double w = relative(y, nodes_, f.a, f.b, o.v);
    for (size_t i : f.levels) {
      const Element& e = elements_[i];
      const double share = e.kind == Kind::kStribeck ? std::exp(-std::abs(w) / e.shape) : 1.0;
      pull(e, {f.sign * share, 0, e.kind == Kind::kStribeck ? -share / e.shape : 0.0,
               e.kind == Kind::kStribeck ? f.sign * share * std::abs(w) / e.shape : 0.0});
    }
  }
  net_ -= o.carried * mass_;
  renew_yield();
  if (held_.empty())
    acc = net_.cwiseQuotient(mass_);
  else
    acc = yield_ * net_;
  if (!held_.empty() && o.a != 0)  // what sticks to the moving base goes with it
    acc += o.a * (by_hold_.transpose() * with_base());
  if (!slopes) return;
  for (size_t i = 0; i < faults_.size(); ++i)
    if (faults_[i].by_value >= 0) {
      const double r = (o.t_s * substeps_ / record_.step_s - static_cast<double>(at_) / 2);
      const Vec& s = fine_slope_[i];
      slope_x_(fine_node_[faults_[i].fine], states() + faults_[i].by_value) +=
          s[at_] + r * (-3 * s[at_] + 4 * s[at_ + 1] - s[at_ + 2]) +
          r * r * (2 * s[at_] - 4 * s[at_ + 1] + 2 * s[at_ + 2]);
    }
  if (by_base_delay_ >= 0 && record_.base.ridden) slope_x_.col(states() + by_base_delay_) -= o.jerk * mass_;
  for (Index node = 0; node < nodes_; ++node)
    for (Index p : by_mass_[static_cast<size_t>(node)]) slope_x_(node, states() + p) -= acc[node] + o.carried;
  if (held_.empty()) {
    for (Index i = 0; i < nodes_; ++i) slope_x_.row(i) /= mass_[i];
    return;
  }
  slope_x_ = yield_ * slope_x_;
  if (by_base_delay_ >= 0 && !record_.base.ridden)
    slope_x_.col(states() + by_base_delay_) += o.jerk * (by_hold_.transpose() * with_base());
}

// Bristles at a later instant of the same step: they relax towards the direction of the way gone since its start.
void Simulator::bend(const Vec& start, Vec& y, const Outside& o0, const Outside& o1, const Mat* s0, Mat* s) const {
  for (const Element& e : elements_) {
    if (e.kind != Kind::kPresliding) continue;
    const Index z = 2 * nodes_ + e.z;
    const double way = relative(y, 0, e.a, e.b, o1.x) - relative(start, 0, e.a, e.b, o0.x);
    const double sign = way < 0 ? -1 : 1, fade = std::exp(-std::abs(way) / e.shape);
    y[z] = sign + (start[z] - sign) * fade;
    if (!s) continue;
    const double by_u = (1 - sign * y[z]) / e.shape;
    s->row(z) = fade * s0->row(z);
    for (int side = 0; side < 2; ++side) {
      const int node = side == 0 ? e.a : e.b;
      if (node >= 0) s->row(z) += (side == 0 ? by_u : -by_u) * (s->row(node) - s0->row(node));
    }
    if (e.by_shape >= 0) (*s)(z, states() + e.by_shape) += (start[z] - sign) * fade * std::abs(way) / e.shape;
  }
}

// One Runge-Kutta step over a part of the present substep, modes held.
void Simulator::step(double from, double length, Vec& y, Mat* s) {
  const double h = length * record_.step_s / substeps_;
  const Outside o0 = outside(from), o1 = outside(from + 0.5 * length), o2 = outside(from + length);
  static thread_local Vec y0, yn;
  y0 = y, yn = y;
  static thread_local Mat s0, sn;
  const Index n = nodes_, c = states() + parameters_;
  if (s) s0 = *s, sn = *s;
  static thread_local Vec kx[4];
  const auto slope = [&](int i, const Outside& o) {
    accelerations(yn, o, acc_[i], s != nullptr);
    kx[i] = yn.segment(n, n);
    if (!s) return;
    kv_[i] = sn.middleRows(n, n);
    ka_[i].noalias() = slope_x_.leftCols(states()).lazyProduct(sn);
    ka_[i].rightCols(parameters_) += slope_x_.rightCols(parameters_);
  };
  const auto move = [&](int i, double part, const Outside& o) {
    yn.head(n) = y0.head(n) + part * h * kx[i];
    yn.segment(n, n) = y0.segment(n, n) + part * h * acc_[i];
    if (s) {
      sn.topRows(n) = s0.topRows(n) + part * h * kv_[i];
      sn.middleRows(n, n) = s0.middleRows(n, n) + part * h * ka_[i];
    }
    if (hysteresis_) bend(y0, yn, o0, o, s ? &s0 : nullptr, s ? &sn : nullptr);
  };
  (void)c;
  slope(0, o0), move(0, 0.5, o1), slope(1, o1), move(1, 0.5, o1), slope(2, o1), move(2, 1, o2), slope(3, o2);
  y.head(n) = y0.head(n) + h / 6 * (kx[0] + 2 * kx[1] + 2 * kx[2] + kx[3]);
  y.segment(n, n) = y0.segment(n, n) + h / 6 * (acc_[0] + 2 * acc_[1] + 2 * acc_[2] + acc_[3]);
  if (s) {
    s->topRows(n) = s0.topRows(n) + h / 6 * (kv_[0] + 2 * kv_[1] + 2 * kv_[2] + kv_[3]);
    s->middleRows(n, n) = s0.middleRows(n, n) + h / 6 * (ka_[0] + 2 * ka_[1] + 2 * ka_[2] + ka_[3]);
  }
  if (hysteresis_) bend(y0, y, o0, o2, s ? &s0 : nullptr, s);
}

// What holds a stuck link, from the last accelerations(): the force that its ends must exchange.
double Simulator::hold_force(const Friction& f, const Outside& o) const {
  const Index own = std::find(held_.begin(), held_.end(), &f) - held_.begin();
  const double carried = o.a != 0 ? o.a * inner_inverse_.row(own).dot(with_base()) : 0;
  return by_hold_.row(own).dot(net_) - carried;
}

// A link's rate has come to zero: it sticks, or slides on in the other direction.
void Simulator::turn(Friction& f, double at, Vec& y, Mat* s) {
  const Outside o = outside(at);
  Vec before, after;
  accelerations(y, o, before, false);
  const double falling = relative(before, 0, f.a, f.b, o.a);
  const int was = f.sign;
  f.sign = 0, yield_old_ = true;
  accelerations(y, o, after, false);
  const double hold = hold_force(f, o), most = level(f, 0);
  if (std::abs(hold) > most) {
    f.sign = hold > 0 ? 1 : -1, yield_old_ = true;
    if (f.sign == was && std::abs(falling) > 0) f.sign = -was;  // it came here falling
    accelerations(y, o, after, false);
  }
  const double w = relative(y, nodes_, f.a, f.b, o.v);  // what the search for the instant left
  if (f.sign == 0) {
    if (f.a >= 0 && f.b >= 0) {
      const double share = mass_[f.b] / (mass_[f.a] + mass_[f.b]);
      y[nodes_ + f.a] -= share * w, y[nodes_ + f.b] += (1 - share) * w;
    } else if (f.a >= 0) {
      y[nodes_ + f.a] -= w;
    } else if (f.b >= 0) {
      y[nodes_ + f.b] += w;
    }
  }
  if (!s || std::abs(falling) < 1e-12) return;
  Eigen::RowVectorXd g = Eigen::RowVectorXd::Zero(s->cols());
  if (f.a >= 0) g += s->row(nodes_ + f.a);
  if (f.b >= 0) g -= s->row(nodes_ + f.b);
  const Vec jump = (after - before) / falling;
  s->middleRows(nodes_, nodes_) += jump * g;
}

void Simulator::release(const Vec& y, double at) {
  bool any = false;
  for (const Friction& f : friction_) any = any || f.sign == 0;
  if (!any) return;
  const Outside o = outside(at);
  Vec acc;
  accelerations(y, o, acc, false);
  for (Friction& f : friction_) {
    if (f.sign != 0) continue;
    const double hold = hold_force(f, o);
    if (std::abs(hold) <= level(f, 0)) continue;
    f.sign = hold > 0 ? 1 : -1, yield_old_ = true;
    return;  // the others are looked at after the next step
  }
}

Vec Simulator::guessed_state(Index sample) const {
  Vec y = Vec::Zero(states());
  const Index dofs = static_cast<Index>(record_.guess.size()) - 1;
  for (Index i = 0; i < dofs; ++i) {
    const Guess& g = record_.guess[static_cast<size_t>(i)];
    y[i] = g.x[sample], y[nodes_ + i] = g.v[sample];
  }
  for (const Element& e : elements_) {
    if (e.kind == Kind::kResonance) y[e.b] = y[e.a], y[nodes_ + e.b] = y[nodes_ + e.a];
    if (e.kind == Kind::kPresliding) {
      const double v = record_.guess.back().given ? record_.guess.back().v[sample] : 0;
      y[2 * nodes_ + e.z] = relative(y, nodes_, e.a, e.b, v) < 0 ? -1 : 1;
    }
  }
  return y;
}

void Simulator::start(Index sample, const Vec& y) {
  at_ = std::min(sample, record_.samples - 2) * 2 * substeps_;
  const Outside o = outside(0);
  for (Friction& f : friction_) f.sign = relative(y, nodes_, f.a, f.b, o.v) < 0 ? -1 : 1;
  yield_old_ = true;
}

bool Simulator::advance(Index sample, Vec& y, Mat* s) {
  const Index columns = states() + parameters_;
  if (s) {
    s->setZero(states(), columns);
    s->leftCols(states()).setIdentity();
  }
  static thread_local Mat kept;
  for (int sub = 0; sub < substeps_; ++sub) {
    at_ = (sample * substeps_ + sub) * 2;
    double from = 0;
    for (int events = 0; from < 1; ++events) {
      const Vec y0 = y;
      if (s && !friction_.empty()) kept = *s;
      step(from, 1 - from, y, s);
      if (friction_.empty()) break;
      // the first of the links whose rate has passed zero
      double first = 2;
      Friction* turning = nullptr;
      const Outside o0 = outside(from), o1 = outside(1);
      for (Friction& f : friction_) {
        if (f.sign == 0) continue;
        const double w0 = f.sign * relative(y0, nodes_, f.a, f.b, o0.v),
                     w1 = f.sign * relative(y, nodes_, f.a, f.b, o1.v);
        if (w1 >= 0) continue;
        const double share = w0 <= 0 ? 0 : w0 / (w0 - w1);
        if (share < first) first = share, turning = &f;
      }
      if (!turning) {
        release(y, 1);
        break;
      }
      double share = first;
      for (int search = 0; search < 3 && share > 1e-9; ++search) {  // secant on the rate
        y = y0;
        step(from, share * (1 - from), y, nullptr);
        const double w0 = turning->sign * relative(y0, nodes_, turning->a, turning->b, o0.v);
        const double w =
            turning->sign * relative(y, nodes_, turning->a, turning->b, outside(from + share * (1 - from)).v);
        if (w0 <= 0 || std::abs(w) < 1e-6 * w0) break;
        share = std::clamp(share * w0 / (w0 - w), 0.0, 1.0);
      }
      y = y0;
      if (s) *s = kept;
      if (share > 1e-9) step(from, share * (1 - from), y, s);
      from += share * (1 - from);
      if (events >= kMostEvents) {
        turning->sign = 0, yield_old_ = true;
        if (events >= 2 * kMostEvents) return false;
        continue;
      }
      turn(*turning, from, y, s);
      if (from > 1 - 1e-9) break;
    }
    if (!y.allFinite()) return false;
  }
  return true;
}

void Simulator::accelerations(Index sample, const Vec& y, Vec& a, Mat* slopes) {
  const bool last = sample + 1 >= record_.samples;
  at_ = (last ? sample - 1 : sample) * 2 * substeps_;
  if (last) at_ += 2 * (substeps_ - 1);
  const Outside o = outside(last ? 1 : 0);
  accelerations(y, o, a, slopes != nullptr);
  a.array() += o.carried;
  if (!slopes) return;
  *slopes = slope_x_;
  if (by_base_delay_ >= 0 && record_.base.ridden) slopes->col(states() + by_base_delay_).array() += o.jerk;
}

double Simulator::elongation(const Vec& y, size_t link, Index sample) const {
  const auto [a, b] = link_ends_[link];
  return relative(y, 0, a, b, record_.guess.back().given ? record_.guess.back().x[sample] : 0);
}

// Without masses the motion is given and the forces follow. Rates near zero have half a sign (slopes stay bounded).
void Simulator::forces_of_motion(const Mat& x, const Mat& v, const Mat& a, Mat& force, std::vector<Mat>& slopes) const {
  const Index n = nodes_, count = x.cols();
  (void)a;
  force.setZero(n, count);
  slopes.assign(static_cast<size_t>(parameters_), Mat());
  for (Mat& m : slopes) m.setZero(n, count);
  for (const Element& e : elements_) {
    const auto end = [&](const Mat& m, int i, Index k) { return i >= 0 ? m(i, k) : 0.0; };
    double z = 0, z_slope = 0, before = 0;
    for (Index k = 0; k < count; ++k) {
      const double u = end(x, e.a, k) - end(x, e.b, k), w = end(v, e.a, k) - end(v, e.b, k);
      LawValue f;
      if (e.kind == Kind::kPresliding) {
        if (k == 0) z = w < 0 ? -1 : 1, before = u;
        const double way = u - before, sign = way < 0 ? -1 : 1, fade = std::exp(-std::abs(way) / e.shape);
        z_slope = z_slope * fade + (z - sign) * fade * std::abs(way) / e.shape;
        z = sign + (z - sign) * fade, before = u;
        f.force = z, f.by_log_shape = z_slope;
      } else if (e.kind == Kind::kCoulomb || e.kind == Kind::kMissingCoulomb || e.kind == Kind::kStribeck) {
        const double spread =
            k + 1 < count && k > 0
                ? 0.25 * std::abs(end(v, e.a, k + 1) - end(v, e.b, k + 1) - end(v, e.a, k - 1) + end(v, e.b, k - 1))
                : 0;
        const double sign = spread > 0 ? std::clamp(w / spread, -1.0, 1.0) : w < 0 ? -1.0 : 1.0;
        const double share = e.kind == Kind::kStribeck ? std::exp(-std::abs(w) / e.shape) : 1;
        f.force = sign * share, f.by_log_shape = e.kind == Kind::kStribeck ? sign * share * std::abs(w) / e.shape : 0;
      } else {
        f = law(e.kind, u, w, law_time(record_.time_s(k), e.shape, record_), e.shape, e.shape2);
      }
      for (int side = 0; side < 2; ++side) {
        const int node = side == 0 ? e.a : e.b;
        if (node < 0) continue;
        const double turn = side == 0 ? 1 : -1;
        force(node, k) += turn * e.value * f.force;
        if (e.by_value >= 0) slopes[static_cast<size_t>(e.by_value)](node, k) += turn * f.force;
        if (e.by_shape >= 0) slopes[static_cast<size_t>(e.by_shape)](node, k) += turn * e.value * f.by_log_shape;
        if (e.by_phase >= 0) slopes[static_cast<size_t>(e.by_phase)](node, k) += turn * e.value * f.by_phase;
      }
    }
  }
}

}  // namespace diagnosis::runs

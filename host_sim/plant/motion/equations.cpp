#include "host_sim/plant/motion/equations.hpp"

#include <algorithm>

#include "host_sim/vocabulary/law_table.hpp"

namespace host_sim {

Equations::Node Equations::node(const double* y, const Motion& base, size_t index) const {
  if (index < masses()) return {y[index], y[masses() + index]};
  if (index == base_node()) return {base.value, base.rate};
  return {0.0, 0.0};
}

vocabulary::Point Equations::point(const PlantTerm& term, double t_s, double u, double w, int sign, const double* z,
                                   const Modes& modes) const {
  vocabulary::Point at;
  at.u = u, at.w = w, at.t_s = t_s, at.sign = sign;
  const int memories = vocabulary::kLaws[static_cast<size_t>(term.kind)].memories;
  for (int m = 0; m < memories; ++m) at.z[m] = z[term.memory + static_cast<size_t>(m)];
  if (!modes.gap_side.empty()) at.side = modes.gap_side[term.gap];
  return at;
}

void Equations::net_forces(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                           double* net) const {
  const double* z = y + 2 * masses();
  const auto law = [&](const PlantTerm& term, double u, double w, int sign) {
    switch (term.kind) {  // what nearly all links consist of needs no table
      case vocabulary::EffectKind::kStiffness:
        return u;
      case vocabulary::EffectKind::kViscous:
        return w;
      case vocabulary::EffectKind::kCoulomb:
        return static_cast<double>(sign);
      default:
        return vocabulary::force_value(term.kind, point(term, t_s, u, w, sign, z, modes), term.shape);
    }
  };
  const auto sum = [&](const std::vector<PlantTerm>& terms, double u, double w, int sign) {
    double f = 0.0;
    for (const PlantTerm& term : terms) f += term.coefficient * law(term, u, w, sign);
    return f;
  };
  for (size_t i = 0; i < masses(); ++i) {
    net[i] = force[i];
    if (!on_drive_[i].empty()) net[i] -= sum(on_drive_[i], force[i], 0.0, 0);
    if (!on_dof_[i].empty()) net[i] -= sum(on_dof_[i], y[i], y[masses() + i], 0);
  }
  for (size_t l = 0; l < links_.size(); ++l) {
    const PlantLink& link = links_[l];
    const Node a = node(y, base, link.a), b = node(y, base, link.b);
    const double f = sum(link.terms, a.x - b.x, a.v - b.v, modes.rate_sign[l]);
    if (link.a < masses()) net[link.a] -= f;
    if (link.b < masses()) net[link.b] += f;
  }
}

void Equations::accelerations(const double* net, const Motion& base, const Modes& modes, double* a) const {
  const std::vector<bool> joined = stuck_links(modes);
  if (joined.empty()) {
    for (size_t i = 0; i < masses(); ++i) a[i] = net[i] / mass_[i];
    return;
  }
  const std::vector<size_t> body = bodies(joined);
  std::vector<double> sum(masses() + 2, 0.0), inertia(masses() + 2, 0.0);
  for (size_t i = 0; i < masses(); ++i) {
    sum[body[i]] += net[i];
    inertia[body[i]] += mass_[i];
  }
  for (size_t i = 0; i < masses(); ++i) {
    if (body[i] == body[ground()])
      a[i] = 0.0;
    else if (body[i] == body[base_node()])
      a[i] = base.acceleration;
    else
      a[i] = sum[body[i]] / inertia[body[i]];
  }
}

void Equations::derivative(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                           double* dy) const {
  const size_t n = masses();
  net_forces(t_s, y, force, base, modes, dy + n);
  accelerations(dy + n, base, modes, dy + n);
  for (size_t i = 0; i < n; ++i) dy[i] = y[n + i];
  if (memory_of_.empty()) return;
  for (size_t l = 0; l < links_.size(); ++l) {
    const Node a = node(y, base, links_[l].a), b = node(y, base, links_[l].b);
    memory_rates(links_[l].terms, {a.x - b.x, a.v - b.v}, t_s, modes.rate_sign[l], y, modes, dy);
  }
  for (size_t i = 0; i < n; ++i) memory_rates(on_dof_[i], {y[i], y[n + i]}, t_s, 0, y, modes, dy);
}

void Equations::memory_rates(const std::vector<PlantTerm>& terms, const Node& at, double t_s, int sign, const double* y,
                             const Modes& modes, double* dy) const {
  const size_t first = 2 * masses();
  for (const PlantTerm& term : terms) {
    const vocabulary::Law& law = vocabulary::law_of(term.kind);
    if (law.memories == 0) continue;
    const vocabulary::MemoryRate rate =
        law.memory_rate(point(term, t_s, at.x, at.v, sign, y + first, modes), term.shape);
    for (int m = 0; m < law.memories; ++m) dy[first + term.memory + static_cast<size_t>(m)] = rate.value[m];
  }
}

bool Equations::linear_between_events() const {
  const auto none = [](const std::vector<PlantTerm>& terms) { return terms.empty(); };
  const auto linear = [](const PlantTerm& term) {
    return term.kind == vocabulary::EffectKind::kStiffness || term.kind == vocabulary::EffectKind::kViscous ||
           term.kind == vocabulary::EffectKind::kCoulomb;
  };
  return gaps_ == 0 && memory_of_.empty() && std::all_of(on_dof_.begin(), on_dof_.end(), none) &&
         std::all_of(on_drive_.begin(), on_drive_.end(), none) &&
         std::all_of(links_.begin(), links_.end(),
                     [&](const PlantLink& link) { return std::all_of(link.terms.begin(), link.terms.end(), linear); });
}

double Equations::memory_scale(size_t memory, const MotionScale& scale) const {
  const MemoryPlace& place = memory_of_[memory];
  if (firmware::row_of(place.kind).nature.memory != firmware::Memory::kHiddenMass) return 1.0;
  return place.entry == 0 ? scale.displacement : scale.velocity;
}

std::vector<double> Equations::initial_state(const std::vector<double>& x, const std::vector<double>& v,
                                             const Motion& base) const {
  const size_t n = masses();
  std::vector<double> y(states(), 0.0);
  for (size_t i = 0; i < n; ++i) {
    y[i] = i < x.size() ? x[i] : 0.0;
    y[n + i] = i < v.size() ? v[i] : 0.0;
  }
  const auto start = [&](const std::vector<PlantTerm>& terms, double u, double w) {
    for (const PlantTerm& term : terms)
      if (vocabulary::law_of(term.kind).memories > 0)
        vocabulary::start_memory(term.kind, vocabulary::point(term.kind, u, w, 0.0, term.shape), term.shape,
                                 &y[2 * n + term.memory]);
  };
  for (const PlantLink& link : links_) {
    const Node a = node(y.data(), base, link.a), b = node(y.data(), base, link.b);
    start(link.terms, a.x - b.x, a.v - b.v);
  }
  for (size_t i = 0; i < n; ++i) start(on_dof_[i], y[i], y[n + i]);
  return y;
}

}  // namespace host_sim

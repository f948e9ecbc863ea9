#include "host_sim/reports/views/balance_views.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/data/channel_words.hpp"

namespace host_sim::reports {
namespace {

// Work of a force on a DOF since the start, J.
std::vector<double> work(const Series& force, const Series& velocity, double sign, double period_s) {
  std::vector<double> out(force.size(), 0.0);
  for (size_t i = 1; i < out.size(); ++i)
    out[i] = out[i - 1] + sign * 0.5 * period_s * (force[i - 1] * velocity[i - 1] + force[i] * velocity[i]);
  return out;
}

void add_to(std::vector<double>& sum, const std::vector<double>& values) {
  for (size_t i = 0; i < sum.size(); ++i) sum[i] += values[i];
}

// What the extended rig has more than the given one in a link.
Series addition(const ForceBalance& given, const ForceBalance& extended, size_t link) {
  Series more = extended.links[link].total();
  const Series before = given.links[link].total();
  double largest = 0.0;
  for (size_t i = 0; i < more.size(); ++i) {
    more[i] -= before[i];
    largest = std::max(largest, std::abs(more[i]));
  }
  return largest > 0.0 ? more : Series();
}

}  // namespace

EnergyBalance energy_balance(const rig_file::RigModel& rig, const ForceBalance& given, const ForceBalance& extended,
                             int dof, const std::vector<double>& time_s, double period_s) {
  const size_t index = static_cast<size_t>(dof - 1);
  const Series& velocity = given.velocity[index];
  EnergyBalance energy;
  energy.time_s = time_s;
  const std::vector<double> drive = work(given.drive[index], velocity, 1.0, period_s);
  std::vector<double> stored = work(given.inertia[index], velocity, -1.0, period_s);
  std::vector<NamedSeries> losses;
  for (size_t l = 0; l < rig.links.size(); ++l) {
    if (rig.links[l].a != dof && rig.links[l].b != dof) continue;
    const double sign = rig.links[l].a == dof ? -1.0 : 1.0;
    for (const ForceTerm& term : given.links[l].terms) {
      const std::vector<double> done = work(term.force, velocity, sign, period_s);
      if (term.conservative) {
        add_to(stored, done);
      } else {
        losses.push_back({term.name, done});
      }
    }
  }
  if (std::any_of(drive.begin(), drive.end(), [](double value) { return value != 0.0; }))
    energy.terms.push_back({"drive", drive});
  energy.terms.push_back({"inertia and springs", stored});
  energy.terms.insert(energy.terms.end(), losses.begin(), losses.end());
  energy.residual = work(given.residual[index], velocity, 1.0, period_s);
  energy.residual_extended = work(extended.residual[index], extended.velocity[index], 1.0, period_s);
  return energy;
}

Series at_link(const rig_file::Link& link, const ForceBalance& balance) {
  Series force = balance.residual[static_cast<size_t>(link.a - 1)];
  if (link.b > 0)
    for (size_t i = 0; i < force.size(); ++i)
      force[i] = 0.5 * (force[i] - balance.residual[static_cast<size_t>(link.b - 1)][i]);
  return force;
}

LinkView link_view(const rig_file::RigModel& given_rig, const rig_file::RigModel& extended_rig, size_t index,
                   const ForceBalance& given, const ForceBalance& extended, const std::vector<double>& time_s) {
  const rig_file::Link& link = given_rig.links[index];
  const bool rotates = rig_file::link_rotates(given_rig, link);
  LinkView view;
  view.link = rig_file::link_label(link);
  view.force_unit = quantity_unit(Quantity::kForce, rotates);
  view.elongation_unit = quantity_unit(Quantity::kDisplacement, rotates);
  view.rate_unit = quantity_unit(Quantity::kVelocity, rotates);
  view.time_s = time_s;
  view.elongation = given.links[index].elongation;
  view.rate = given.links[index].rate;
  view.residual = at_link(link, given);
  view.residual_extended = at_link(link, extended);
  const rig_file::Link& more = extended_rig.links[index];
  if (more.effects.size() > link.effects.size()) {
    view.named_force = addition(given, extended, index);
    view.named_effect = more.effects.back().kind;
  }
  return view;
}

}  // namespace host_sim::reports

#include "host_sim/reports/data/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/force_balance/derivative.hpp"
#include "host_sim/force_balance/force_balance.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "host_sim/reports/data/channel_words.hpp"
#include "host_sim/reports/data/free_simulation.hpp"
#include "host_sim/reports/data/rig_views.hpp"
#include "host_sim/vocabulary/held_in_place.hpp"

namespace host_sim::reports {
namespace {

constexpr double kRestart_s = 1.0;

// Both rigs beside the record; a record without channels: no simulation.
struct Simulations {
  Record given, extended;
};

std::vector<size_t> start_samples(const Record& record, const rig_file::RigModel& rig) {
  std::vector<size_t> starts = {0};
  if (!vocabulary::held_in_place(rig)) {
    const size_t step = std::max<size_t>(2, static_cast<size_t>(std::lround(kRestart_s / record.sample_period_s)));
    for (size_t at = step; at + step <= record.samples(); at += step) starts.push_back(at);
  }
  return starts;
}

Record try_to_simulate(const Side& side, const Record& record, const char* name, std::vector<std::string>& notes) {
  const rig_file::RigModel& rig = side.rig;
  const bool massless = std::any_of(rig.dofs.begin(), rig.dofs.end(),
                                    [](const rig_file::Dof& dof) { return !(dof.mass_kg.value > 0.0); });
  if (massless) return {};
  const std::vector<size_t> starts = start_samples(record, rig);
  if (side.simulated != nullptr && starts.size() == 1) return *side.simulated;
  try {
    return simulate_from(rig, record, starts);
  } catch (const PlantError& error) {
    notes.push_back(std::string("the ") + name + " cannot be simulated: " + error.what());
    return {};
  }
}

const std::vector<double>* values_of(const Record& record, Quantity quantity, int dof) {
  const Channel* channel = record.find(quantity, dof);
  return channel == nullptr ? nullptr : &channel->values;
}

// The velocity by way of the displacement, of the length of the record.
std::vector<double> derived_velocity(const Record& record, int dof) {
  const std::vector<double>* x = values_of(record, Quantity::kDisplacement, dof);
  if (x == nullptr || x->size() <= 2 * kDerivativeMargin) return {};
  std::vector<double> inner = first_derivative(*x, record.sample_period_s);
  std::vector<double> out(kDerivativeMargin, inner.front());
  out.insert(out.end(), inner.begin(), inner.end());
  out.resize(x->size(), inner.back());
  return out;
}

Waveform waveform(const Record& measured, const Simulations& simulated, Quantity quantity, int dof, bool rotates) {
  Waveform out;
  out.quantity = quantity_word(quantity, rotates);
  out.unit = quantity_unit(quantity, rotates);
  const auto take = [&](const Record& from, std::vector<double>& into) {
    if (const std::vector<double>* values = values_of(from, quantity, dof)) into = *values;
  };
  take(measured, out.measured);
  take(simulated.given, out.simulated);
  take(simulated.extended, out.extended);
  if (out.measured.empty()) {
    out.measured = derived_velocity(measured, dof);
    out.note = "The measured one is derived from the " + quantity_word(Quantity::kDisplacement, rotates) + ".";
  }
  return out;
}

// Position and, beside it, the fastest quantity that is measured; the velocity derived where there is only the
// position.
std::vector<Waveform> waveforms(const Record& measured, const Simulations& simulated, int dof, bool rotates) {
  std::vector<Waveform> out;
  const auto has = [&](Quantity quantity) { return measured.find(quantity, dof) != nullptr; };
  if (has(Quantity::kDisplacement)) out.push_back(waveform(measured, simulated, Quantity::kDisplacement, dof, rotates));
  const Quantity fast = has(Quantity::kAcceleration) ? Quantity::kAcceleration : Quantity::kVelocity;
  out.push_back(waveform(measured, simulated, fast, dof, rotates));
  return out;
}

// Without simulation: the measured force beside the one that each rig needs for the measured motion.
Waveform force_waveform(const ForceBalance& given, const ForceBalance& extended, size_t index, bool rotates) {
  Waveform out{quantity_word(Quantity::kForce, rotates),
               quantity_unit(Quantity::kForce, rotates),
               given.reference[index],
               given.reference[index],
               extended.reference[index],
               "Simulated: what the rig needs for the measured motion."};
  for (size_t i = 0; i < out.measured.size(); ++i) {
    out.simulated[i] -= given.residual[index][i];
    out.extended[i] -= extended.residual[index][i];
  }
  return out;
}

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

// The force that this link alone would have to add to make up for the residuals of its ends (least squares).
Series at_link(const rig_file::Link& link, const ForceBalance& balance) {
  Series force = balance.residual[static_cast<size_t>(link.a - 1)];
  if (link.b > 0)
    for (size_t i = 0; i < force.size(); ++i)
      force[i] = 0.5 * (force[i] - balance.residual[static_cast<size_t>(link.b - 1)][i]);
  return force;
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

// An integrated acceleration drifts: energies made with it are pictures of the drift.
bool velocity_known(const Record& record, int dof) {
  return record.find(Quantity::kVelocity, dof) != nullptr || record.find(Quantity::kDisplacement, dof) != nullptr;
}

// Links that only the extended rig has, without any force.
rig_file::RigModel with_links_of(rig_file::RigModel rig, const rig_file::RigModel& extended) {
  for (size_t l = rig.links.size(); l < extended.links.size(); ++l) {
    rig_file::Link link;
    link.a = extended.links[l].a;
    link.b = extended.links[l].b;
    rig.links.push_back(link);
  }
  return rig;
}

}  // namespace

Comparison compare(const Record& record, const Side& given) {
  Comparison out = compare(record, given, Side{given.rig, given.simulated});
  for (DofView& view : out.dofs) {
    for (Waveform& waveform : view.waveforms) waveform.extended.clear();
    view.energy.residual_extended.clear();
  }
  for (LinkView& link : out.links) link.residual_extended.clear();
  return out;
}

Comparison compare(const Record& record, const Side& given_side, const Side& extended_side) {
  Comparison out;
  const rig_file::RigModel& extended = extended_side.rig;
  const rig_file::RigModel given = with_links_of(given_side.rig, extended);
  const double period_s = record.sample_period_s;
  Simulations simulated;
  simulated.given = try_to_simulate({given, given_side.simulated}, record, "rig as given", out.notes);
  simulated.extended = &given_side.rig == &extended ? simulated.given
                                                    : try_to_simulate(extended_side, record, "extended rig", out.notes);
  const bool free = !simulated.given.channels.empty();
  if (free && !vocabulary::held_in_place(given))
    out.notes.push_back(
        "nothing holds the rig in its place: the simulations restart from the measured state every second");
  const ForceBalance before = force_balance(given, record), after = force_balance(extended, record);
  std::vector<double> time_s(before.residual.front().size());
  for (size_t i = 0; i < time_s.size(); ++i)
    time_s[i] = record.start_s + static_cast<double>(i + kDerivativeMargin) * period_s;
  for (size_t i = 0; i < given.dofs.size(); ++i) {
    const int dof = static_cast<int>(i + 1);
    DofView view;
    view.dof = dof;
    view.start_s = free ? record.start_s : time_s.front();
    view.period_s = period_s;
    view.waveforms = free ? waveforms(record, simulated, dof, given.dofs[i].rotating)
                          : std::vector<Waveform>{force_waveform(before, after, i, given.dofs[i].rotating)};
    if (velocity_known(record, dof)) view.energy = energy_balance(given, before, after, dof, time_s, period_s);
    out.dofs.push_back(std::move(view));
  }
  for (size_t l = 0; l < given.links.size(); ++l)
    if (elongation_measured(record, given.links[l]))
      out.links.push_back(link_view(given, extended, l, before, after, time_s));
  return out;
}

}  // namespace host_sim::reports

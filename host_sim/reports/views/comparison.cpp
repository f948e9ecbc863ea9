#include "host_sim/reports/views/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/force_balance/derivative.hpp"
#include "host_sim/force_balance/force_balance.hpp"
#include "host_sim/plant/motion/fitted_start.hpp"
#include "host_sim/plant/motion/free_run.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "host_sim/reports/data/channel_words.hpp"
#include "host_sim/reports/views/balance_views.hpp"
#include "host_sim/reports/views/free_simulation.hpp"
#include "host_sim/reports/views/rig_views.hpp"
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
  if (!runs_freely(rig)) return {};
  const std::vector<size_t> starts = start_samples(record, rig);
  if (side.simulated != nullptr && starts.size() == 1) return *side.simulated;
  try {
    return run_beside(rig, record, starts);
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
  const bool free = out.free = !simulated.given.channels.empty();
  if (free && !vocabulary::held_in_place(given))
    out.notes.push_back("nothing holds the rig in its place: the simulations begin anew every second");
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

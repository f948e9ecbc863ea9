#include <algorithm>
#include <cmath>

#include "advice.hpp"
#include "answer/answer.hpp"
#include "first_screen/rows_say.hpp"

namespace diagnosis {

const char* verdict_word(Verdict v) {
  constexpr const char* kWords[] = {"none", "explained", "partly", "ambiguous", "unknown"};
  return kWords[static_cast<size_t>(v)];
}

namespace {

bool massless(const rig_file::RigModel& rig) {
  return std::all_of(rig.dofs.begin(), rig.dofs.end(),
                     [](const rig_file::Dof& d) { return !d.mass_kg.estimate && d.mass_kg.value == 0; });
}

bool springs_and_masses_known(const rig_file::RigModel& rig) {
  return std::none_of(rig.dofs.begin(), rig.dofs.end(), [](const rig_file::Dof& d) { return d.mass_kg.estimate; }) &&
         std::none_of(rig.links.begin(), rig.links.end(),
                      [](const rig_file::Link& l) { return l.stiffness_N_m.estimate; });
}

// Gains and delays of motion channels as the simulation's candidates, one per channel and kind.
void add_faults(const std::vector<SensorFault>& faults, std::vector<runs::Candidate>& list,
                std::vector<double>& values) {
  for (const SensorFault& f : faults) {
    if (is_hum(f.kind)) continue;
    runs::Candidate c;
    c.terms = {on_dof(f.kind == FaultKind::kGain ? Kind::kChannelGain : Kind::kChannelDelay, static_cast<int>(f.dof))};
    c.terms[0].quantity = static_cast<int>(f.quantity);
    const auto same = [&](const runs::Candidate& o) { return o.same_place(c); };
    if (std::any_of(list.begin(), list.end(), same)) continue;  // of a further record
    list.push_back(c), values.push_back(f.value);
  }
}

bool two_channels_a_dof(const runs::Prepared& p) { return p.traces.size() > p.guess.size() - 1; }

// The rows' terms as the simulation's candidates; false where it has no such term.
bool as_candidates(const runs::Model& model, const RowsSay& say, std::vector<runs::Candidate>& list) {
  for (const Term& t : say.terms) {
    runs::Candidate c;
    c.terms = {t};
    if (t.kind >= Kind::kForceHumCos50 && t.kind <= Kind::kForceHumSin60) return false;
    if (t.kind == Kind::kBacklash || t.kind == Kind::kPresliding)
      for (size_t i = 0; i < model.size(); ++i)
        if (model[i].term.link == t.link &&
            (t.kind == Kind::kBacklash ? model[i].term.kind == Kind::kStiffness : model[i].term.kind == Kind::kCoulomb))
          c.host = static_cast<int>(i);
    list.push_back(c);
  }
  return true;
}

constexpr double kMostlyNoise = 0.8;  // of the squared residual

// The rows' answer stands where nothing is left beyond their noise and runs that have not seen the data bear it out.
bool rows_stand(const runs::Task& task, const runs::Choice& fitted, const RowsSay& say, runs::State& with_them) {
  with_them = fitted.base;
  if (!say.noise_only) return false;
  std::vector<runs::Candidate> list;
  if (!as_candidates(fitted.base.model, say, list)) return true;
  std::vector<double> values = say.values;
  add_faults(say.faults, list, values);
  return list.empty() || runs::borne_out(task, fitted.base, list, values, &with_them);
}

// The rows' answer, where it stands; otherwise what it found out that the free runs may use.
bool answered_by_rows(const Asked& asked, const runs::Task& task, runs::Choice& choice, RowsSay& say, Diagnosis& d) {
  try {
    say = ask_rows(task.system, asked);
  } catch (const CannotAnswer&) {  // too few rows: the free runs alone
  }
  say.asked = true;
  choice.noise_is_enough = say.noise_only;
  d.unknown_trace = say.d.unknown_trace;
  runs::State with_them;
  if (!rows_stand(task, choice, say, with_them)) return false;
  d = say.d;
  runs::widen(task, with_them, d.extended.parameters);
  if (say.terms.empty()) d.baseline.parameters = d.extended.parameters;
  for (Cause& c : d.causes) runs::widen(task, with_them, c.parameters);
  for (double gain : d.gain) d.remainder_percent.push_back(100 / std::max(gain, 1e-3));
  return true;
}

// Names what is missing by free runs, from the rig as given with the sensor faults that they bear out.
void answer_by_runs(const Asked& asked, const runs::Task& task, const RowsSay& say, runs::Choice& choice) {
  if (!massless(asked.rig) && two_channels_a_dof(task.records[0])) {
    std::vector<runs::Candidate> list;
    std::vector<double> values;
    add_faults(say.asked ? say.faults : motion_faults(asked), list, values);
    if (!list.empty() && runs::borne_out(task, choice.base, list, values)) runs::adopt(task, list, values, choice);
  }
  const auto& progress = asked.options.progress;
  runs::choose(task, choice, [&](double share) {
    if (progress) progress(0.6 + 0.3 * share);
  });
}

}  // namespace

Diagnosis diagnose(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                   const std::vector<host_sim::Record>& holdout, const Options& options) {
  if (training.empty()) throw CannotAnswer("no record to diagnose");
  const auto progress = [&](double share) {
    if (options.progress) options.progress(share);
  };
  const Asked asked{rig, training, holdout, options};
  const System system = make_system(rig);
  const std::vector<runs::Prepared> records = runs::prepare_all(rig, training, holdout);
  const runs::Task task{system, records, training.size()};
  runs::Choice choice = runs::rig_fitted(task);
  progress(0.3);
  Diagnosis d;
  RowsSay say;
  const bool right = !massless(rig) && runs::right(task, choice);
  const bool rows_can_tell = runs::forced(records) && !massless(rig) && springs_and_masses_known(rig);
  if (!right && !massless(rig) && !rows_can_tell)
    choice.noise_is_enough = runs::noise_share(choice.base_left, choice.base.fit) > kMostlyNoise;
  const bool answered =
      !right && rows_can_tell && !choice.base_fits_nothing && answered_by_rows(asked, task, choice, say, d);
  progress(0.6);
  if (!answered) {
    if (!right) answer_by_runs(asked, task, say, choice);
    runs::answer(task, choice, d);
  }
  runs::name_holds(task, d);
  for (const std::string& advice : advice_for(d)) d.advice.push_back(advice);
  progress(1);
  return d;
}

}  // namespace diagnosis

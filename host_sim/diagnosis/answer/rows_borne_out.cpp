#include "rows_borne_out.hpp"

#include <algorithm>

#include "../channels/rounded_jumps.hpp"
#include "../choice/free_damping.hpp"
#include "../choice/horizon.hpp"
#include "../hums/hum.hpp"
#include "../numbers/between_rivals.hpp"
#include "../numbers/numbers_of.hpp"
#include "../residual/most_noise.hpp"
#include "../terms/naming.hpp"
#include "../trial/bristles.hpp"
#include "../unseen/compare_unseen.hpp"
#include "beside_noise.hpp"
#include "rows_outdone.hpp"
#include "run_limits.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kNoWorse = 1.1;  // of what a free run of unseen data misses: beside noise that hides the motion

struct Found {
  std::vector<Candidate> list;
  std::vector<std::vector<double>> values;
  void add(Candidate c, std::vector<double> value) {
    const auto same = [&](const Candidate& o) { return o.same_place(c); };
    if (std::any_of(list.begin(), list.end(), same)) return;  // of a further record
    list.push_back(std::move(c)), values.push_back(std::move(value));
  }
};

// Gains and delays of motion channels, one per channel and kind. A hum is a nuisance and no cause of what the rig does; a
// high-pass has been undone in the record. What channels of a moving base contradict each other in is no term of a DOF.
void add_faults(const Task& task, const std::vector<SensorFault>& faults, Found& found) {
  for (const SensorFault& f : faults) {
    if (is_hum(f.kind) || f.kind == FaultKind::kAcCoupling || f.dof >= task.system.rig.dofs.size()) continue;
    Candidate c;
    c.terms = {on_dof(f.kind == FaultKind::kGain ? Kind::kChannelGain : Kind::kChannelDelay, static_cast<int>(f.dof))};
    c.terms[0].quantity = static_cast<int>(f.quantity);
    found.add(c, {f.value});
  }
}

// The rows' terms as the simulation's; a force's hum, which it has no term for, is left out.
void add_terms(const Model& model, const RowsSay& say, Found& found) {
  for (size_t k = 0; k < say.terms.size(); ++k) {
    const Term& t = say.terms[k];
    if (is_force_hum(t.kind)) continue;
    Candidate c;
    c.terms = {t};
    if (t.kind == Kind::kBacklash || t.kind == Kind::kPresliding)
      for (size_t i = 0; i < model.size(); ++i)
        if (model[i].term.link == t.link &&
            (t.kind == Kind::kBacklash ? model[i].term.kind == Kind::kStiffness : model[i].term.kind == Kind::kCoulomb))
          c.host = static_cast<int>(i);
    found.add(c, {say.values[k]});
  }
}

Found found_by(const Task& task, const Model& model, const RowsSay& say) {
  Found found;
  add_terms(model, say, found);
  add_faults(task, say.faults, found);
  return found;
}

// as_good: what may be in the place of what they name.
bool stands(const Task& task, const Choice& fitted, const RowsSay& say, State& with_them,
            std::vector<NamedPlace>& as_good) {
  with_them = fitted.base;
  if (!say.left.noise_only) return false;
  const Found found = found_by(task, fitted.base.model, say);
  if (found.list.empty()) return true;
  return borne_out(task, fitted.base, found.list, found.values, &with_them) &&
         missed_percent(task, with_them) < kNoWorse * missed_percent(task, fitted.base) &&
         !outdone(task, fitted, found.list, with_them) &&
         (found.list.size() > 1 || stands_in_noise(task, fitted, found.list[0], with_them, as_good));
}

// The rows carry the noise of a derived motion: where they see nothing the runs, which need none, may leave more than noise. Whether they
// name what it is and free runs of unseen data are the better for it; choice has it then.
bool runs_see_more(const Task& task, const RowsSay& say, Choice& choice) {
  if (!say.left.noise_only || !found_by(task, choice.base.model, say).list.empty()) return false;
  if (choice.base_left.worst() <= kSurelyNoise && !worth_a_search(task, choice.base, choice.base_left)) return false;
  Choice runs = choice;
  choose(task, runs, [](double) {});
  // how a force is held between its samples is taken out of the rows alone, and a channel's delay or gain may stand for it
  const bool any_of_sensors = std::any_of(runs.named.begin(), runs.named.end(), [](const Named& n) {
    const Kind kind = n.candidate.terms[0].kind;
    return of_force_sensor(kind) || of_motion_channel(kind);
  });
  if (runs.named.empty() || any_of_sensors || missed_percent(task, runs.final) >= missed_percent(task, choice.base))
    return false;
  choice = runs, choice.searched = true;
  return true;
}

// A rig file that is wrong by much (a mass of twice its size: its accelerations are) follows its recording over no window,
// and short windows tell little. Where it does with what the rows name, windows are as long as a right one's: true, and
// choice goes on from there.
bool followed_with(const Task& task, const RowsSay& say, Choice& choice) {
  Choice over_long = over_windows(task, choice, longest_horizon(task.records));
  if (!over_long.base.fit.ok || over_long.base.unseen.empty()) return false;
  const Found found = found_by(task, over_long.base.model, say);
  State with_them;
  if (found.list.empty() || !borne_out(task, over_long.base, found.list, found.values, &with_them) ||
      !(motion_error(task, with_them) < kFollows))
    return false;
  over_long.base_left = left_by(task.system, task.records, over_long.base);
  over_long.base_fits_nothing = false;
  choice = over_long;
  if (!say.left.noise_only) adopt(task, found.list, found.values, choice);  // there is more to look for
  return true;
}

bool any_contradicts(const std::vector<diagnosis::Parameter>& rows, const std::vector<diagnosis::Parameter>& runs) {
  for (const diagnosis::Parameter& p : rows)
    for (const diagnosis::Parameter& o : runs)
      if (p.name == o.name && !of_sensor(p) && contradicts(p, o)) return true;
  return false;
}

// The runs' error has valleys beside the lowest: fitted from the rows' numbers, where that leaves less. True where it does.
bool from_rows(const Task& task, const RowsSay& say, State& fitted) {
  State other = fitted;
  for (ModelTerm& t : other.model)
    for (const Valued& a : say.model)
      if (!t.known && t.host < 0 && a.term.same_place(t.term)) t.value = a.value, t.term.shape = a.term.shape;
  settle(task, other, kBaseSteps);
  if (!other.fit.ok || (fitted.fit.ok && !(other.fit.cost < fitted.fit.cost))) return false;
  fitted = other;
  return true;
}

}  // namespace

bool answered_by_rows(const Asked& asked, const Task& task, std::vector<Prepared>& records, Choice& choice,
                      RowsSay& say, Diagnosis& d) {
  try {
    say = ask_rows(task.system, asked);
  } catch (const CannotAnswer&) {  // too few rows: the free runs alone
  }
  say.asked = true;
  choice.noise_is_enough = say.left.noise_only && say.terms.empty();  // with its terms is not without them
  d.unknown_trace = say.d.unknown_trace;
  const bool tells = !choice.base_fits_nothing && choice.periods >= kLeastPeriods;
  if (!tells && !followed_with(task, say, choice) && choice.base_fits_nothing) return false;
  if (runs_see_more(task, say, choice)) return false;
  State with_them;
  std::vector<NamedPlace> as_good;
  if (!stands(task, choice, say, with_them, as_good)) {
    for (const Cause& c : say.d.causes)
      if (!c.taken_out) d.rejected.push_back(c);
    return false;
  }
  d = say.d;
  for (const NamedPlace& place : as_good) list_equal(place, d), d.verdict = Verdict::kAmbiguous;
  const bool rounded = round_jumps(task, records, with_them);
  // a force that is held between its samples is none of the free runs' terms
  const bool held = d.force_between_samples == "steps" && !task.records[0].held;
  const bool damped = !held && free_damping(task, with_them);
  const bool refitted =
      any_contradicts(d.extended.parameters, numbers_of(task, with_them)) && from_rows(task, say, with_them);
  const std::vector<diagnosis::Parameter> numbers = numbers_of(task, with_them);
  // numbers of one fit belong together: a friction means nothing with the rate at which that of another falls
  const bool theirs = damped || (!held && any_contradicts(d.extended.parameters, numbers));
  if (theirs) {
    d.extended_rig = written_rig(task, with_them);
    state_delays(d.causes, d.extended_rig);
  }
  take_numbers(numbers, theirs, d.extended.parameters);
  if (say.terms.empty()) d.baseline.parameters = d.extended.parameters;
  for (Cause& c : d.causes) take_numbers(numbers, theirs, c.parameters);
  const size_t found = found_by(task, choice.base.model, say).list.size();
  if (found == 1) mark_rows_rivals(task, choice, with_them, d);
  raise_limits(task, with_them, d.minimum_detectable);  // as the rows' are: beside what is named
  compare_unseen(task, choice.base, with_them, !d.causes.empty(), choice.base_left.sensor_noise, d);
  const bool as_given = !rounded && !refitted && found == 0;
  choice.final = with_them;
  choice.final_left = as_given ? choice.base_left : left_by(task.system, task.records, with_them);
  // Of one channel: the rows see what channels of a DOF contradict each other in. A force's hum that they name is in the runs.
  const bool of_force =
      std::any_of(say.terms.begin(), say.terms.end(), [](const Term& t) { return is_force_hum(t.kind); });
  if (!of_force) name_hum(task, choice, d);
  return true;
}

// One after the other, the strongest first: what a large fault leaves to the channels beside it is none of theirs.
void adopt_faults(const Task& task, const std::vector<SensorFault>& faults, Choice& choice) {
  Found found, kept;
  add_faults(task, faults, found);
  for (size_t i = 0; i < found.list.size(); ++i) {
    Found with = kept;
    with.add(found.list[i], found.values[i]);
    if (borne_out(task, choice.base, with.list, with.values)) kept = with;
  }
  const size_t before = choice.named.size();
  if (!kept.list.empty()) adopt(task, kept.list, kept.values, choice);
  const std::vector<MotionTrace>& traces = task.records[0].traces;
  for (size_t i = before; i < choice.named.size(); ++i)
    choice.named[i].of_channels = std::count_if(traces.begin(), traces.end(), [&](const MotionTrace& t) {
                                    return t.dof == choice.named[i].candidate.terms[0].dof;
                                  }) > 1;
}

}  // namespace diagnosis::runs

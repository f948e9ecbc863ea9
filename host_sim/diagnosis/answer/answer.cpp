#include "answer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../choice/horizon.hpp"
#include "../choice/most_noise.hpp"
#include "../motion/drive_noise.hpp"
#include "../terms/naming.hpp"
#include "between_rivals.hpp"
#include "hum.hpp"
#include "lasting_error.hpp"
#include "materiality.hpp"
#include "possible_causes.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kLikeAHold = 0.1;        // of half a sample
constexpr double kNoNumber = 1e3;         // times what was fitted: of what only a sum is known
constexpr double kHalfOfVariance = 70.7;  // NRMSE in percent

// A shape is fitted in its logarithm, but for a phase.
void take_std(const Parameter& parameter, const Determined& found, ActiveTerm& to) {
  const Term& t = to.term;
  if (parameter.shape == 0)
    to.std = found.std, to.alike = found.alike;
  else if (parameter.shape == 1)
    to.shape_std = found.std * t.shape;
  else
    to.shape2_std = t.kind == Kind::kCogging ? found.std : found.std * t.shape2;
}

// As the words and units of terms are kept. A backlash and what acts in another's place have that one's coefficient.
std::vector<ActiveTerm> active(const Model& model, const std::vector<Determined>& found) {
  std::vector<ActiveTerm> list;
  for (const ModelTerm& t : model) {
    ActiveTerm a;
    a.term = t.term, a.known = t.known && t.host < 0, a.added = t.added;
    a.value = t.host >= 0 ? model[static_cast<size_t>(t.host)].value : t.value;
    if (t.term.kind == Kind::kBacklash && t.added)
      a.value = -a.value;  // a rig file takes its stiffness away inside the gap
    if (t.host >= 0) a.known = model[static_cast<size_t>(t.host)].known;
    list.push_back(a);
  }
  const std::vector<Parameter> parameters = runs::parameters_of(model);
  for (size_t i = 0; i < parameters.size() && i < found.size(); ++i)
    take_std(parameters[i], found[i], list[parameters[i].term]);
  for (size_t i = 0; i < model.size(); ++i)
    if (model[i].host >= 0) list[i].std = list[static_cast<size_t>(model[i].host)].std;
  return list;
}

// The first that is measured of displacement, velocity and acceleration.
std::string base_channel(const Task& task) {
  constexpr const char* kNames[] = {"displacement_base_m", "velocity_base_m_s", "acceleration_base_m_s2"};
  const auto& reading = task.records[0].base.reading;
  size_t quantity = 0;
  while (quantity < 2 && reading[quantity].size() == 0) ++quantity;
  return kNames[quantity];
}

std::string place(const Task& task, const Term& t) {
  if (t.kind == Kind::kBaseDelay) return "channel " + base_channel(task);
  if (of_motion_channel(t.kind))
    for (const MotionTrace& trace : task.records[0].traces)
      if (trace.dof == t.dof && trace.quantity == t.quantity) return "channel " + trace.channel;
  return place_of(task.system, t, FusedRecord());
}

std::vector<diagnosis::Parameter> parameters_of_cause(const Task& task, const std::vector<ActiveTerm>& list,
                                                      const ActiveTerm& a) {
  if (!of_motion_channel(a.term.kind)) return parameters_of_term(task.system, list, a);
  const std::string channel = place(task, a.term).substr(8);
  const bool delay = a.term.kind == Kind::kChannelDelay || a.term.kind == Kind::kBaseDelay;
  return {{std::string(word_of(a.term.kind)) + "[" + channel + "]", a.value, delay ? "s" : "1", a.std, true}};
}

std::vector<diagnosis::Parameter> all_parameters(const Task& task, const std::vector<ActiveTerm>& list) {
  std::vector<diagnosis::Parameter> out;
  for (const ActiveTerm& a : list)
    if (a.added || !a.known)
      for (diagnosis::Parameter& p : parameters_of_cause(task, list, a)) {
        p.undetermined = a.alike;
        if (a.alike) p.std = std::max(p.std, kNoNumber * std::abs(p.value));
        out.push_back(p);
      }
  return out;
}

void take(const Score& score, ModelScore& to) {
  to.holdout_nrmse_percent = score.nrmse_percent, to.holdout_mse_percent = score.mse_percent;
  to.holdout_velocity_nrmse_percent = score.velocity_percent;
}

// A force that is held between its samples acts half a sample late on the mean: its readings come early by that much.
bool is_hold(const Task& task, const Cause& c) {
  const bool of_force = c.where.rfind("channel force", 0) == 0 || c.where.rfind("channel torque", 0) == 0;
  if (c.effect != "sensor_delay" || !of_force || c.parameters.empty()) return false;
  const double half = 0.5 * task.records[0].read_every_s;
  return std::abs(c.parameters[0].value + half) < kLikeAHold * half + 2 * c.parameters[0].std;
}

using Terms = std::vector<ActiveTerm>;

void add_rivals(const Task& task, const Named& named, Cause& c, Diagnosis& d) {
  for (const Rival& r : named.rivals) {
    const NamedPlace other = named_place(task, r.candidate.terms[0]);
    c.rivals.push_back(other);
    list_equal(other, d);
  }
}

void name_causes(const Task& task, const Choice& choice, const Terms& full, Diagnosis& d) {
  for (const Named& named : choice.named) {
    Cause c;
    c.effect = word_of(named.candidate.terms[0].kind), c.where = place(task, named.candidate.terms[0]);
    c.significance = named.z * named.z;
    c.explains_percent = std::clamp(100 * named.share, 0.0, 100.0);
    for (const ActiveTerm& a : full)
      if (a.added && a.term.same_place(named.candidate.terms[0])) c.parameters = parameters_of_cause(task, full, a);
    add_rivals(task, named, c, d);
    d.causes.push_back(c);
  }
}

// What a rig file can state: a channel's fault and what changes from record to record it cannot.
rig_file::RigModel written_rig(const Task& task, const Terms& full) {
  Terms writable;
  for (const ActiveTerm& a : full)
    if (!of_motion_channel(a.term.kind) && a.term.shape != kAcrossRecords) writable.push_back(a);
  return extended_rig(task.system, writable);
}

}  // namespace

rig_file::RigModel written_rig(const Task& task, const State& fitted) {
  return written_rig(task, active(fitted.model, determined(fitted.fit, fitted.model)));
}

namespace {

// Windows shorter than a period follow anything from their own states: what is noise there need not be over the records.
bool windows_tell(const Task& task, const Choice& choice) {
  return choice.periods >= std::min(kLeastPeriods, longest_horizon(task.records));
}

Verdict verdict_of(const Task& task, const Choice& choice, bool noise, double worst_free_run, const Diagnosis& d) {
  if (!choice.named.empty())
    return !d.ambiguous_with.empty() ? Verdict::kAmbiguous : d.more_remains ? Verdict::kPartly : Verdict::kExplained;
  if (choice.base_fits_nothing && !right(task, choice)) return Verdict::kUnknown;
  const bool nothing_missing =
      noise || right(task, choice) || near_enough(task, choice) ||
      (choice.noise_is_enough && worst_free_run < kHalfOfVariance && motion_error(task, choice.final) < kFollows) ||
      (worst_free_run < 100 * kSmall && motion_error(task, choice.final) < kSmall);
  return nothing_missing ? Verdict::kNone : Verdict::kUnknown;
}

void withdraw_causes(const Task& task, const Terms& base, Diagnosis& d) {
  d.causes.clear(), d.ambiguous_with.clear(), d.more_remains = false;
  d.extended = d.baseline;
  std::fill(d.gain.begin(), d.gain.end(), 1.0);
  std::fill(d.remainder_percent.begin(), d.remainder_percent.end(), 100.0);
  d.extended_rig = extended_rig(task.system, base);
}

// What the rows named and the runs did not: what those name themselves in the end was not rejected.
void keep_rejected(Diagnosis& d) {
  const auto named = [&](const Cause& r) {
    const auto same = [&](const auto& o) { return o.effect == r.effect && o.where == r.where; };
    return std::any_of(d.causes.begin(), d.causes.end(), same) ||
           std::any_of(d.ambiguous_with.begin(), d.ambiguous_with.end(), same);
  };
  d.rejected.erase(std::remove_if(d.rejected.begin(), d.rejected.end(), named), d.rejected.end());
}

void say_cannot_describe(const Task& task, const Choice& choice, Diagnosis& d) {
  d.baseline.parameters.clear(), d.extended.parameters.clear();  // numbers of a model that is not this rig's
  char text[200];
  std::snprintf(
      text, sizeof text,
      "Even over %.2g of a period, each from its own best start, its simulation misses %.0f %% of the motion.",
      choice.periods, std::min(100.0, 100 * motion_error(task, choice.final)));
  d.cannot_describe = text;
  std::snprintf(
      text, sizeof text,
      "count the modes in the spectrum (the rig file has %zu DOF), and check the units and the channels' places",
      task.system.dofs());
  d.advice.push_back(text);
}

constexpr double kMuchOfIt = 0.5;  // of what a free run misses: then nothing else needs to be wrong

// Noise of a force that is simulated drives the rig: what the run misses by that no model can mend.
void say_noise_of_drives(const Task& task, const Score& score, Diagnosis& d) {
  const bool astray = score.worst_percent > 100;  // of a model so far off nothing is noise's
  if (!d.driven || astray || score.worst_percent < kHalfOfVariance ||
      score.by_drives_percent < kMuchOfIt * score.worst_percent)
    return;
  char text[320];
  std::snprintf(text, sizeof text,
                "noise or ripple of the channel that drives the rig alone makes such a run miss %.0f %%: the intervals "
                "allow for it, %s; use the commanded force, or average repeated runs",
                score.by_drives_percent,
                drives_are_much_noise(task.records)
                    ? "and for a lasting error of that channel of an eighth of its noise"
                    : "but not for a lasting error of that channel");
  d.advice.push_back(text);
}

// A channel so coarse for the motion that its steps alone put a run as far off as one may be and still follow: what it misses by them is
// not the rig's fault.
void say_steps(const Score& score, Diagnosis& d) {
  for (size_t dof = 0; dof < score.by_steps_percent.size(); ++dof) {
    const double steps = score.by_steps_percent[dof];
    if (steps < 100 * kFollows || steps < kMuchOfIt * score.nrmse_percent[dof]) continue;
    char text[240];
    std::snprintf(text, sizeof text,
                  "the unseen motion of DOF %zu is too small for the steps of its channel: they alone make any run "
                  "miss %.0f %% of it; "
                  "record with finer steps, a larger motion, or less of its quiet end",
                  dof + 1, steps);
    d.advice.push_back(text);
  }
}

}  // namespace

NamedPlace named_place(const Task& task, const Term& term) { return {word_of(term.kind), place(task, term)}; }

void list_equal(const NamedPlace& place, Diagnosis& d) {
  if (std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), place) == d.ambiguous_with.end())
    d.ambiguous_with.push_back(place);
}

double compare_unseen(const Task& task, const State& base, const State& with_causes, bool any_cause, const Vec& noise,
                      Diagnosis& d) {
  const Score before = score_unseen(task, base, &noise),
              after = any_cause ? score_unseen(task, with_causes, &noise) : before;
  take(before, d.baseline), take(after, d.extended);
  say_noise_of_drives(task, after, d);
  say_steps(after, d);
  d.gain.clear();
  for (size_t i = 0; i < before.nrmse_percent.size(); ++i) {
    const double old = before.nrmse_percent[i], now = after.nrmse_percent[i];
    d.gain.push_back(old / std::max(1e-9, now));
    d.remainder_percent.push_back(any_cause ? std::min(1000.0, 100 * now / std::max(1e-9, old)) : 100);
  }
  return after.worst_percent;
}

bool of_sensor(const diagnosis::Parameter& p) { return p.name.rfind("sensor_", 0) == 0; }

bool contradicts(const diagnosis::Parameter& rows, const diagnosis::Parameter& runs) {
  return std::max(rows.std, runs.std) > 0 && rows.estimated &&
         std::abs(rows.value - runs.value) > kByChance * std::hypot(rows.std, runs.std);
}

std::vector<diagnosis::Parameter> numbers_of(const Task& task, const State& fitted) {
  if (!fitted.fit.ok) return {};
  return all_parameters(task, active(fitted.model, determined_beside_drives(task, fitted)));
}

std::vector<diagnosis::Parameter> values_of(const Task& task, const Model& model) {
  return all_parameters(task, active(model, {}));
}

void take_numbers(const std::vector<diagnosis::Parameter>& runs, bool values_too,
                  std::vector<diagnosis::Parameter>& parameters) {
  for (diagnosis::Parameter& p : parameters) {
    const auto other =
        std::find_if(runs.begin(), runs.end(), [&](const diagnosis::Parameter& o) { return o.name == p.name; });
    if (other == runs.end() || !p.estimated) continue;
    if (values_too && !of_sensor(p))
      p.value = other->value, p.std = other->std;
    else
      p.std = std::max(p.std, other->std);
  }
}

void name_holds(const Task& task, Diagnosis& d) {
  for (Cause& c : d.causes)
    if (is_hold(task, c)) c.effect = "force_hold", c.parameters.clear(), d.force_between_samples = "steps";
  for (size_t dof = 0; task.records[0].held && dof < task.records[0].force.size(); ++dof) {
    if (task.records[0].force[dof].size() == 0) continue;
    Cause c;
    c.effect = "force_hold", c.where = "channel " + force_channel(task.system.rig, dof), c.taken_out = true;
    if (!d.names(c.effect, c.where)) d.causes.push_back(c);
    d.force_between_samples = "steps";
  }
  if (task.records[0].held && d.verdict == Verdict::kNone) d.verdict = Verdict::kExplained;
  if (task.records[0].held && d.verdict == Verdict::kUnknown) d.verdict = Verdict::kPartly;
}

void answer(const Task& task, const Choice& choice, Diagnosis& d) {
  const Terms base = active(choice.base.model, determined_beside_drives(task, choice.base));
  const Terms full = active(choice.final.model, determined_beside_drives(task, choice.final));
  name_causes(task, choice, full, d);
  d.baseline.parameters = all_parameters(task, base), d.extended.parameters = all_parameters(task, full);
  const double worst_free_run =
      compare_unseen(task, choice.base, choice.final, !choice.named.empty(), choice.final_left.sensor_noise, d);
  d.extended_rig = written_rig(task, full);
  state_delays(d.causes, d.extended_rig);
  d.baseline_misfit = choice.base_left.worst(), d.extended_misfit = choice.final_left.worst();
  const bool noise = choice.final.fit.ok && !beyond_noise(choice.final_left) && worst_free_run < kHalfOfVariance &&
                     (worst_free_run < 100 * kFollows || windows_tell(task, choice)) &&
                     (choice.final_left.worst() <= kSurelyNoise || motion_error(task, choice.final, false) < kFollows);
  d.more_remains = !choice.named.empty() && (!noise || may_bend_numbers(choice.final_left));
  d.verdict = verdict_of(task, choice, noise, worst_free_run, d);
  if (immaterial(task, choice, noise, worst_free_run, base, full, d)) {
    withdraw_causes(task, base, d);
    // what runs astray was needed all the same, where the rig alone leaves more than noise
    const bool needed = worst_free_run > 100 && beyond_noise(choice.base_left);
    d.verdict =
        (noise && !needed) || motion_error(task, choice.base) < kAsGoodAsRight ? Verdict::kNone : Verdict::kUnknown;
  }
  if (!d.causes.empty()) mark_between_rivals(task, choice, d);
  if (!choice.base_fits_nothing) say_possible(task, choice, d);
  if (choice.base_fits_nothing && choice.named.empty()) say_cannot_describe(task, choice, d);
  name_hum(task, choice, d);
  keep_rejected(d);
}

}  // namespace diagnosis::runs

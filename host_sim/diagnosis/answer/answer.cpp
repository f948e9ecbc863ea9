#include "answer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../choice/horizon.hpp"
#include "../doubts/materiality.hpp"
#include "../hums/hum.hpp"
#include "../numbers/between_rivals.hpp"
#include "../numbers/lasting_error.hpp"
#include "../numbers/numbers_of.hpp"
#include "../residual/most_noise.hpp"
#include "../unseen/compare_unseen.hpp"
#include "../unseen/score.hpp"
#include "cannot_describe.hpp"
#include "possible_causes.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kLikeAHold = 0.1;  // of half a sample

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
    c.effect = word_of(named.candidate.terms[0].kind), c.where = place_of_term(task, named.candidate.terms[0]);
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
  return written_rig(task, fitted_terms(fitted.model, determined(fitted.fit, fitted.model)));
}

namespace {

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

}  // namespace

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
  const Terms base = fitted_terms(choice.base.model, determined_beside_drives(task, choice.base));
  const Terms full = fitted_terms(choice.final.model, determined_beside_drives(task, choice.final));
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
  const bool nothing = follows_nothing(task, choice, d);
  if (nothing) withdraw_causes(task, base, d), d.verdict = Verdict::kUnknown;
  if (!d.causes.empty()) mark_between_rivals(task, choice, d);
  if (!choice.base_fits_nothing && !nothing) say_possible(task, choice, d);
  if (nothing || (choice.base_fits_nothing && choice.named.empty())) say_cannot_describe(task, choice, d);
  name_hum(task, choice, d);
  keep_rejected(d);
}

}  // namespace diagnosis::runs

#include "judged.hpp"

#include <algorithm>
#include <cmath>

#include "advice.hpp"
#include "answer/beside_noise.hpp"
#include "answer/rows_borne_out.hpp"
#include "answer/run_limits.hpp"
#include "by_runs.hpp"
#include "channels/common_lag.hpp"
#include "channels/held_force.hpp"
#include "channels/zero_of_channel.hpp"
#include "doubts/odd_record.hpp"
#include "doubts/trifles.hpp"
#include "doubts/worse_unseen.hpp"
#include "hums/force_hum.hpp"
#include "hums/hum.hpp"
#include "hums/mains_hum.hpp"
#include "numbers/between_rivals.hpp"
#include "numbers/clock.hpp"
#include "numbers/scale.hpp"
#include "numbers/undetermined.hpp"
#include "residual/most_noise.hpp"
#include "valleys/wrong_numbers.hpp"

namespace diagnosis {
namespace {

// Of the records, in motion: at rest there is noise alone, and friction that holds is no law of motion.
constexpr double kKeptMoving = 0.7;
constexpr size_t kLeastDecays = 3;  // two for the fit

bool springs_and_masses_known(const rig_file::RigModel& rig) {
  return std::none_of(rig.dofs.begin(), rig.dofs.end(), [](const rig_file::Dof& d) { return d.mass_kg.estimate; }) &&
         std::none_of(rig.links.begin(), rig.links.end(),
                      [](const rig_file::Link& l) { return l.stiffness_N_m.estimate; });
}

constexpr double kNoiseIsEnough = 0.8;  // of the squared residual

// Where nothing is named nothing is gained: what was compared was with causes that were taken back since.
void compare_nothing(Diagnosis& d) {
  if (!d.causes.empty()) return;
  std::fill(d.gain.begin(), d.gain.end(), 1.0);
  std::fill(d.remainder_percent.begin(), d.remainder_percent.end(), 100.0);
}

// Rivals of a cause are those that are still said.
void state_rivals(Diagnosis& d) {
  const auto unsaid = [&](const NamedPlace& p) {
    return std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), p) == d.ambiguous_with.end();
  };
  for (Cause& c : d.causes) c.rivals.erase(std::remove_if(c.rivals.begin(), c.rivals.end(), unsaid), c.rivals.end());
  if (d.causes.size() == 1) d.causes[0].rivals = d.ambiguous_with;
}

// What is left of a rig that follows its motion goes with it: a force that no effect explains may be in its numbers.
void doubt_all_numbers(const runs::Task& task, const runs::Choice& choice, Diagnosis& d) {
  const bool more = runs::beyond_noise(choice.final_left) && choice.final_left.worst() > runs::kBeyondNoise;
  if (!choice.final.fit.ok || !more || runs::near_enough(task, choice)) return;
  d.more_remains = true;
  for (ModelScore* score : {&d.baseline, &d.extended})
    for (Parameter& p : score->parameters) p.may_be_bent = true;
}

// The rig as given fitted to the records, less what its drives hold and the mains add: `records` are changed where they have it.
runs::Choice rig_alone(const runs::Task& task, std::vector<runs::Prepared>& records) {
  runs::Choice choice = runs::rig_fitted(task);
  if (!runs::massless(task.system.rig) && !runs::right(task, choice) && runs::held_force(task, records, choice))
    choice = runs::rig_fitted(task);
  std::vector<runs::Hum> hum = runs::take_out_hum(task, choice, records);
  if (!hum.empty()) choice = runs::rig_fitted(task), choice.hum_taken = std::move(hum);
  return choice;
}

// What is missing beside the rig alone, by the equations' rows or by free runs.
struct Answered {
  bool right = false;    // nothing is
  bool by_rows = false;  // who says so
};
Answered answer(const Asked& asked, const runs::Task& task, std::vector<runs::Prepared>& records, bool kept_moving,
                runs::Choice& choice, Diagnosis& d) {
  const bool massless = runs::massless(asked.rig), right = !massless && runs::right(task, choice);
  const bool rows_can_tell = runs::forced(records) && kept_moving && !massless && springs_and_masses_known(asked.rig);
  if (!right && !massless && !rows_can_tell)
    choice.noise_is_enough = runs::noise_share(choice.base_left, choice.base.fit) > kNoiseIsEnough;
  RowsSay say;
  runs::Choice numbers = choice;
  const runs::Wrong wrong = right ? runs::Wrong::kNo : runs::name_wrong_numbers(task, numbers);
  const bool by_rows = !right && wrong != runs::Wrong::kSurely && rows_can_tell &&
                       runs::answered_by_rows(asked, task, records, choice, say, d);
  if (asked.options.progress) asked.options.progress(0.6);
  if (by_rows) return {right, by_rows};
  if (wrong == runs::Wrong::kSurely)
    choice = numbers;
  else if (!right)
    answer_by_runs(asked, task, say, wrong == runs::Wrong::kNo ? nullptr : &numbers, choice);
  answer_beside_rounded_jumps(task, records, choice, d);
  if (d.verdict == Verdict::kNone && trace_is_there(task, say, choice)) d.verdict = Verdict::kUnknown;
  return {right, by_rows};
}

// Of a rig whose every unknown may be anything, what is not seen may be missing all the same.
bool nothing_is_determined(const Diagnosis& d) {
  const std::vector<Parameter>& numbers = d.baseline.parameters;
  return d.verdict == Verdict::kNone && d.causes.empty() && !numbers.empty() &&
         std::all_of(numbers.begin(), numbers.end(), [](const Parameter& p) { return p.undetermined; });
}

// What channels of all kinds add to an answer, and what of it is no answer. Returns the lag of all motion channels, s; 0: none.
double say_of_channels(const runs::Task& task, const runs::Choice& choice, Diagnosis& d) {
  runs::name_holds(task, d);
  if (d.verdict != Verdict::kUnknown) runs::name_force_hum(task, choice.final, d);
  const double lag_s = runs::say_common_lag(task, d);
  runs::say_shared_hum(task, choice, d);
  const bool any_named = !d.causes.empty();
  runs::drop_undetermined(d, runs::motion_error(task, choice.base) < runs::kFollows);
  runs::drop_trifles(task, d);
  if (any_named && d.causes.empty()) d.extended_rig = runs::written_rig(task, choice.base);  // as it was given
  runs::name_zeros(task, d);
  runs::reject_what_simulates_worse(task.system.rig, d);
  return lag_s;
}

}  // namespace

Diagnosis judged(const Asked& asked, double& lag_s) {
  const auto& [rig, training, holdout, options, ground_known] = asked;
  const auto progress = [&](double share) {
    if (asked.options.progress) asked.options.progress(share);
  };
  const System system = make_system(rig, ground_known);
  std::vector<runs::Prepared> records = runs::prepare_all(rig, training, holdout);
  const bool kept_moving = runs::moving_share(records) > kKeptMoving;
  // The last swings of a decay are too small to bear anything out: of several decays the last is the unseen one.
  const bool last_unseen = holdout.empty() && !kept_moving && training.size() >= kLeastDecays;
  const runs::Task task{system, records, training.size() - (last_unseen ? 1 : 0)};
  runs::Choice choice = rig_alone(task, records);
  progress(0.3);
  Diagnosis d;
  d.driven = runs::forced(records) || records[0].guess.back().given;
  const Answered answered = answer(asked, task, records, kept_moving, choice, d);
  lag_s = say_of_channels(task, choice, d);
  if (d.verdict == Verdict::kNone && !answered.right) {
    runs::doubt_numbers(task, choice.final, choice.final_left, d);
    if (!answered.by_rows && choice.named.empty()) doubt_all_numbers(task, choice, d);
  }
  runs::say_odd_record(task, choice, d);
  runs::say_scale(task, d);
  runs::say_clock(task, d);
  compare_nothing(d);
  state_rivals(d);
  runs::mark_replaceable(d);
  runs::mark_undetermined(task, d);
  d.determines_nothing = nothing_is_determined(d);
  if (d.determines_nothing) d.minimum_detectable.clear();  // beside a model of which nothing is known
  if (d.verdict == Verdict::kNone && !d.determines_nothing && d.minimum_detectable.empty())
    d.minimum_detectable = runs::limits_of_runs(task, choice.base);
  for (const std::string& advice : advice_for(d)) d.advice.push_back(advice);
  progress(1);
  return d;
}

}  // namespace diagnosis

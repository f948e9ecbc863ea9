#include "by_runs.hpp"

#include "answer/answer.hpp"
#include "answer/rows_borne_out.hpp"
#include "channels/rounded_jumps.hpp"
#include "residual/leaves_trace.hpp"

namespace diagnosis {
namespace {

bool two_channels_a_dof(const runs::Prepared& p) { return p.traces.size() > p.guess.size() - 1; }

// Goes on from a fitted rig and names what is missing by free runs.
runs::Choice searched(const Asked& asked, const runs::Task& task, const runs::Choice& from) {
  runs::Choice found = from;
  const auto& progress = asked.options.progress;
  runs::choose(task, found, [&](double share) {
    if (progress) progress(0.6 + 0.3 * share);
  });
  return found;
}

// Numbers of the rig as given beside the accelerometers' rounding of friction's jumps. A cause may stand for what they round: where one
// is named it is not asked.
bool round_jumps(const runs::Task& task, std::vector<runs::Prepared>& records, runs::Choice& choice) {
  if (!choice.named.empty() || !runs::round_jumps(task, records, choice.final)) return false;
  choice.base = choice.final;
  choice.base_left = choice.final_left = runs::left_by(task.system, task.records, choice.final);
  return true;
}

}  // namespace

void answer_by_runs(const Asked& asked, const runs::Task& task, const RowsSay& say, const runs::Choice* numbers,
                    runs::Choice& choice) {
  if (!runs::massless(asked.rig) && two_channels_a_dof(task.records[0]))
    runs::adopt_faults(task, say.asked ? say.faults : motion_faults(asked), choice);
  if (!choice.searched) choice = searched(asked, task, choice);
  const bool explained = choice.final.fit.ok && !choice.named.empty() && !runs::beyond_noise(choice.final_left);
  if (!numbers || explained) return;
  const runs::Choice renumbered = searched(asked, task, *numbers);
  if (!choice.final.fit.ok || runs::missed_percent(task, renumbered.final) < runs::missed_percent(task, choice.final))
    choice = renumbered;
}

bool trace_is_there(const runs::Task& task, const RowsSay& say, const runs::Choice& choice) {
  const Remainder& left = say.left;
  return left.trace_alone && !runs::near_enough(task, choice) &&
         (left.trace_Hz == 0 || runs::leaves_tone(task, choice.final, left.trace_Hz)) &&
         (left.trace_link < 0 || runs::leaves_repetition(task, choice.final, left.trace_link));
}

void answer_beside_rounded_jumps(const runs::Task& task, std::vector<runs::Prepared>& records, runs::Choice& choice,
                                 Diagnosis& d) {
  const Diagnosis before = d;
  round_jumps(task, records, choice);
  runs::answer(task, choice, d);
  if (!d.causes.empty() || choice.named.empty()) return;
  runs::Choice alone = choice;
  alone.named.clear(), alone.final = alone.base, alone.final_left = alone.base_left;
  if (!round_jumps(task, records, alone)) return;
  d = before, choice = alone;
  runs::answer(task, choice, d);
}

}  // namespace diagnosis

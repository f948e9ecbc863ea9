#include "advice.hpp"
#include "along_motion.hpp"
#include "answer/rows_borne_out.hpp"
#include "channels/at_fault.hpp"
#include "channels/filtered_motion.hpp"
#include "channels/own_zeros.hpp"
#include "forces_of_rest.hpp"
#include "judged.hpp"
#include "later_start.hpp"
#include "record/released.hpp"
#include "record/riding.hpp"
#include "sensors/ac_coupling.hpp"
#include "sensors/lone_channel.hpp"

namespace diagnosis {

const char* verdict_word(Verdict v) {
  constexpr const char* kWords[] = {"none", "explained", "partly", "ambiguous", "unknown"};
  return kWords[static_cast<size_t>(v)];
}

namespace {

// Also where all motion channels lag the force.
Diagnosis judged_behind_filters(const Asked& asked) {
  const auto& [rig, training, holdout, options, ground_known] = asked;
  double lag_s = 0;
  const Diagnosis behind_lag = judged(asked, lag_s);
  if (lag_s == 0 || !behind_lag.causes.empty()) return behind_lag;
  const double corner_Hz = runs::corner_of_motion_Hz(rig, training, holdout, lag_s);
  if (corner_Hz == 0) return behind_lag;
  const std::vector<host_sim::Record> fitted = runs::forces_behind(training, corner_Hz),
                                      unseen = runs::forces_behind(holdout, corner_Hz);
  const Options silent{options.top_of_band, nullptr};
  return runs::of_lag_and_filter(behind_lag, judged({rig, fitted, unseen, silent, ground_known}, lag_s), corner_Hz);
}

// With the high-passes undone in the records and named.
Diagnosis judged_without(const std::vector<SensorFault>& couplings, const Asked& asked) {
  Diagnosis told;
  name_ac_couplings(couplings, told);
  std::vector<host_sim::Record> training = asked.training, holdout = asked.holdout;
  for (std::vector<host_sim::Record>* records : {&training, &holdout})
    host_sim::undo_ac_coupling(couplings_of(told), *records);
  Diagnosis d = judged_behind_filters({asked.rig, training, holdout, asked.options, asked.ground_known});
  name_ac_couplings(couplings, d);
  return d;
}

// A high-pass that channels of one DOF tell of is undone before anything else is judged; one that is small and changes nothing is not
// spoken of. Where the rig does not fit then, the force may have one too.
Diagnosis judged_as_coupled(const Asked& asked) {
  std::vector<SensorFault> couplings = ac_couplings(asked);
  if (couplings.empty()) return judged_behind_filters(asked);
  const Diagnosis of_motion = judged_without(couplings, asked);
  const bool alone = of_motion.causes.size() == couplings.size();
  if (alone && of_motion.verdict == Verdict::kExplained && all_small(couplings, asked.training.front())) {
    const Diagnosis as_recorded = judged_behind_filters(asked);
    if (as_recorded.verdict == Verdict::kNone && !undoing_matters(of_motion, as_recorded)) return as_recorded;
  }
  const std::vector<SensorFault> forces = forces_coupled_alike(couplings, asked.training.front());
  if (alone && of_motion.baseline_misfit < kStillNoise) return of_motion;
  if (forces.empty()) return of_motion;
  couplings.insert(couplings.end(), forces.begin(), forces.end());
  const Diagnosis of_all = judged_without(couplings, asked);
  return pays_unseen(of_all, of_motion) ? of_all : of_motion;
}

Diagnosis judged_beside_faults(const Asked& asked) { return judged_without_those_at_fault(asked, judged_as_coupled); }

// Where the rig cannot describe the records at all it may be one kind of sensor that tells another story than the others of the same
// DOFs: an acceleration that is noise, a slip of unit. What the others say, where the rig describes that.
Diagnosis judged_by_those_that_agree(const Asked& asked) {
  const Diagnosis of_all = judged_beside_faults(asked);
  if (of_all.cannot_describe.empty()) return of_all;
  for (const auto quantity :
       {host_sim::Quantity::kAcceleration, host_sim::Quantity::kVelocity, host_sim::Quantity::kDisplacement}) {
    const std::vector<std::string> names = spared_by_others(asked.training.front(), quantity);
    if (names.empty() || go_with_the_others(asked.rig, asked.training, names)) continue;
    const std::vector<host_sim::Record> training = without_channels(asked.training, names),
                                        holdout = without_channels(asked.holdout, names);
    const Asked of_the_others{asked.rig, training, holdout, asked.options, asked.ground_known};
    if (!describes(of_the_others)) continue;
    Diagnosis d = judged_as_coupled(of_the_others);
    d.channels_left_out = names;
    return d;
  }
  return of_all;
}

Diagnosis judged_wherever_its_zeros_are(const Asked& asked) {
  return judged_with_own_zeros(asked, judged_by_those_that_agree);
}

Diagnosis judged_wherever_it_rests(const Asked& asked) {
  return judged_where_it_rests(asked, judged_wherever_its_zeros_are);
}

// Records that determine nothing bear no rig file out.
Diagnosis judged_whenever_it_begins(const Asked& asked) {
  Diagnosis d = judged_from_a_later_start(asked, judged_wherever_it_rests);
  d.determines_nothing = d.determines_nothing && d.verdict == Verdict::kNone && d.causes.empty();
  if (d.determines_nothing) d.verdict = Verdict::kUnknown;
  return d;
}

Diagnosis judged_whatever_holds_it(const Asked& asked) {
  return judged_along_the_motion(asked, judged_whenever_it_begins);
}

}  // namespace

Diagnosis diagnose(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                   const std::vector<host_sim::Record>& holdout, const Options& options) {
  if (training.empty()) throw CannotAnswer("no record to diagnose");
  if (!on_measured_base(rig, training)) {
    if (!any_begins_held(training) && !any_begins_held(holdout))
      return judged_whatever_holds_it({rig, training, holdout, options});
    const std::vector<host_sim::Record> released_training = from_release(training),
                                        released_holdout = from_release(holdout);
    return judged_whatever_holds_it({rig, released_training, released_holdout, options});
  }
  const std::vector<host_sim::Record> riding_training = riding(rig, training), riding_holdout = riding(rig, holdout);
  return judged_whatever_holds_it({rig, riding_training, riding_holdout, options, !base_runs_on(training)});
}

}  // namespace diagnosis

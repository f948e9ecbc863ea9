// What a rig file gets wrong about measured data: which effect, where, how strong, and what naming it gains.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/diagnosis/interval.hpp"
#include "host_sim/records/record.hpp"

namespace diagnosis {

enum class Verdict { kNone, kExplained, kPartly, kAmbiguous, kUnknown };
const char* verdict_word(Verdict verdict);

struct Parameter {
  std::string name;  // "viscous[1-0]", "cubic_stiffness[1-2]", "end_stop_gap[1-0]"
  double value = 0;
  std::string unit;
  double std = 0;  // 0: given, or a shape of a grid
  bool estimated = true;
  bool undetermined = false;  // its interval is wider than all that it is a part of
  bool may_be_bent =
      false;  // by a cause that may be there (Diagnosis::possible), or by what makes its neighbour impossible
};

struct NamedPlace {
  std::string effect, where;
  bool operator==(const NamedPlace& o) const { return effect == o.effect && where == o.where; }
};

struct Cause {
  std::string effect;  // the contract's word
  std::string where;   // "link 1-2", "dof 3", "channel displacement_2_m"
  std::vector<Parameter> parameters;
  double explains_percent = 0;  // share of the residual's excess over noise that it removes; 0 where it is taken out
  double significance = 0;      // fall of chi-squared per unit of the noise that remains
  bool taken_out = false;       // of the record, before the rig is judged: a fault of a motion channel
  std::vector<NamedPlace> rivals = {};  // that explain as much in its place; of a cause among several only where known
};

// A cause that is beyond chance, but takes too little of what is left to be named.
struct PossibleCause {
  NamedPlace place;
  double explains_percent = 0;  // of the residual's excess over noise
  std::vector<Parameter>
      bends;  // what numbers of the rig as given would be beside it, where it takes them out of their intervals
};

struct DetectionLimit {
  std::string effect, where;
  double strength = 0;  // smallest that would have been named in 95 of 100 such records; infinity: these cannot show it
  std::string unit;
  double percent_of_damping_force = 0;  // its rms force over that of its link's damping
  bool same_place(const DetectionLimit& o) const { return effect == o.effect && where == o.where; }
};

// What one effect alone would bring beside the rig as given.
struct RankedCandidate {
  std::string effect, where;
  double score = 0;      // fall of chi-squared per unit of the noise that remains, less what chance may bring
  double threshold = 0;  // a score that it needs to be named
};

struct ModelScore {
  std::vector<Parameter> parameters;
  std::vector<double> holdout_nrmse_percent;  // displacement, per DOF
  // Of the worst DOF; huge where nothing was run.
  double most_missed_percent() const {
    const auto worst = std::max_element(holdout_nrmse_percent.begin(), holdout_nrmse_percent.end());
    return worst == holdout_nrmse_percent.end() ? 1e300 : *worst;
  }
  std::vector<double> holdout_velocity_nrmse_percent;
  std::vector<double> holdout_mse_percent;  // acceleration, Eq. 13, per DOF
};

// Misfit up to which a sentence may call what is left noise: it is 0.95 to 1.05 on complete drawn rigs.
constexpr double kStillNoise = 2;

// A record that does not go with the others; beyond noise, of a free run.
struct OddRecord {
  size_t record = 0;  // from 0, in the order in which they were given
  std::string file;
  double missed_percent = 0, others_percent = 0;  // the others': at most
};

struct Diagnosis {
  Verdict verdict = Verdict::kNone;
  bool baseline_fits() const { return verdict == Verdict::kNone; }
  bool extended_fits() const { return verdict != Verdict::kUnknown && verdict != Verdict::kPartly && !more_remains; }
  bool names(const std::string& effect, const std::string& where) const {
    return std::any_of(causes.begin(), causes.end(),
                       [&](const Cause& c) { return c.effect == effect && c.where == where; });
  }
  // Where no rival is left after all.
  void settle() {
    if (verdict == Verdict::kAmbiguous && ambiguous_with.empty())
      verdict = more_remains ? Verdict::kPartly : Verdict::kExplained;
  }
  // The free run misses much, and what is left over the fitted stretches is noise: a force that is mostly noise does that.
  bool noise_hides() const {
    return verdict == Verdict::kUnknown && causes.empty() && cannot_describe.empty() && !odd_record &&
           !determines_nothing && leaves_noise_alone();
  }
  // Whether what the rig as given leaves is noise, and looks like nothing else.
  bool leaves_noise_alone() const { return baseline_misfit < kStillNoise && unknown_trace.empty(); }
  std::vector<Cause> causes;
  std::vector<NamedPlace> ambiguous_with;  // every cause's rivals
  std::vector<PossibleCause> possible;     // where none is named; the best first
  std::vector<Cause> rejected;             // fitted better, simulated worse on held-out data
  ModelScore baseline, extended;
  std::vector<double> gain;               // baseline / extended NRMSE per DOF
  std::vector<double> remainder_percent;  // per DOF: of what the rig as given leaves on unseen data
  std::vector<DetectionLimit> minimum_detectable;
  std::vector<std::string> advice;
  std::string cannot_describe;  // why the rig file is no model of these records at all; empty: it is one
  std::vector<std::string>
      channels_left_out;  // with which the rig file cannot describe the records, and without which it can
  std::vector<double>
      told_from_s;  // per record, s of its file: the start from which the rig file describes it; empty: all is judged
  bool determines_nothing = false;  // these records no coefficient of the rig, though nothing is seen that it lacks
  bool along_motion = false;        // told of the forces along the motion as measured, which free runs do not follow
  std::optional<OddRecord> odd_record;
  std::string force_between_samples = "smooth";  // or "linear", "steps": how it acts there, as the motion tells
  std::string unknown_trace;                     // what the unexplained force looks like, where it leaves a plain trace
  double baseline_misfit = 0;                    // chi-squared per degree of freedom: 1 is noise alone
  double extended_misfit = 0;
  bool driven = true;  // by a force that is measured, or by a base
  // Beside the named causes, whichever of a set they are, or the rig as given that explains the measurement: more than noise.
  bool more_remains = false;
  rig_file::RigModel extended_rig;
  std::vector<RankedCandidate> ranked;  // the first twelve, best first
};

struct Options {
  double top_of_band = 0.098;            // of the sampling rate: highest frequency of the equation rows
  std::function<void(double)> progress;  // called with the share done, 0 to 1
};

// Throws CannotAnswer (motion.hpp) where the records cannot tell.
Diagnosis diagnose(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& training,
                   const std::vector<host_sim::Record>& holdout, const Options& options = {});

nlohmann::json to_json(const Diagnosis& diagnosis);  // "diagnosis/1"

}  // namespace diagnosis

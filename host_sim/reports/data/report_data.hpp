// What a report shows: plain numbers with labels and units, filled by `host_sim run` and `host_sim diagnose`.
// The pages need nothing else, so that a page can be drawn (and tested) without a simulator.
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/reports/data/rig_view_data.hpp"
#include "host_sim/reports/data/warrant_view.hpp"

namespace host_sim::reports {

struct NamedSeries {
  std::string label;
  std::vector<double> values;
};

// One measured channel beside the simulation of the same channel. All vectors have the length of `measured`,
// or are empty where there is none; the time of sample i is start_s + i * period_s of the DOF.
struct Waveform {
  std::string quantity;  // "displacement"
  std::string unit;      // "m"
  std::vector<double> measured;
  std::vector<double> simulated;  // by the rig file as given, its unknowns estimated
  std::vector<double> extended;   // by the extended rig
  std::string note;               // a sentence below the first picture
};

// Energies since the start of the record, J, all of the length of time_s: what the drive put in, what each term took.
struct EnergyBalance {
  std::vector<double> time_s;
  std::vector<NamedSeries> terms;  // "drive force", "stored", "viscous[1-0]", ...
  std::vector<double> residual;    // what the rig as given leaves unexplained
  std::vector<double> residual_extended;
};

struct DofView {
  int dof = 1;
  double start_s = 0.0, period_s = 0.0;
  std::vector<Waveform> waveforms;
  EnergyBalance energy;
};

// The force that the model of a link leaves unexplained. Vectors of one length; residual_extended, named_force may be
// empty.
struct LinkView {
  std::string link;  // "1-2"
  std::string force_unit = "N", elongation_unit = "m", rate_unit = "m/s";
  std::vector<double> time_s, elongation, rate;
  std::vector<double> residual, residual_extended;
  std::string named_effect;         // "cubic_stiffness": what named_force is
  std::vector<double> named_force;  // force of the named effect at the same samples
};

struct Cause {
  std::string effect, where;            // the contract's words: "cubic_stiffness", "link 1-2"
  double explains_percent = 0.0;        // not a number: taken out of the record before the rig is judged
  std::vector<std::string> parameters;  // "cubic_stiffness[1-2] = 3.1e7 N/m^3 (95 %: 3.0e7 to 3.2e7)"
  std::vector<std::pair<std::string, std::string>> rivals = {};  // effect, where; that explain as much in its place
};

struct Candidate {
  std::string effect, where;
  double score = 0.0;      // gain in chi^2 or whatever the ranking used; larger is better
  double threshold = 0.0;  // score that it had to reach; 0: not given
  bool chosen = false;
  std::string remark;  // why it was dropped
};

struct ParameterChange {
  std::string name, unit;
  Interval before, after;
  std::string status;       // "VALID", ...
  bool impossible = false;  // of the rig as given: below nought beyond its interval
};

struct DofGain {
  int dof = 1;
  double nrmse_before_percent, nrmse_after_percent;  // of the displacement, held-out, free-running; NaN: not known
  double mse_before_percent, mse_after_percent;      // Eq. 13, of the acceleration
};

struct Detectable {
  std::string effect, where, unit;
  double strength = 0.0;  // infinite: at no strength
  double percent_of_damping_force =
      std::numeric_limits<double>::quiet_NaN();  // rms of its force; not of a motion sensor's fault
};

// A cause that may be there, and the first number that it would bend: "viscous[1-0]", "0.029 N s/m".
struct PossibleCause {
  std::string effect, where;
  double explains_percent = 0.0;
  std::string bends, to;  // empty: none
};

struct DiagnosisReportData {
  std::string rig_name;
  std::vector<std::string> files;  // data files
  std::vector<std::string> facts;  // provenance: "20 s at 1000 Hz", "noise: ..."
  std::string verdict;             // none, explained, partly, ambiguous, unknown
  bool leaves_noise_alone = true;  // the rig as given
  bool more_remains = false;       // than noise, beside the named causes
  bool noise_hides = false;        // nothing is explained, and what is left is noise
  std::string cannot_describe;     // a sentence where the rig file is no model of the recording at all; else empty
  std::vector<std::string> channels_left_out;  // that do not go with the others of their DOFs
  bool determines_nothing = false;             // no coefficient, though nothing is seen that the rig file lacks
  bool along_motion = false;                   // told of the forces along the motion as measured
  std::vector<double> told_from_s;             // per record, s: what is said holds from there on; empty: of all
  std::string odd_record;                      // a sentence where one record does not go with the others; else empty
  std::vector<Cause> causes;
  std::vector<PossibleCause> possible;                              // where none is named
  std::vector<std::pair<std::string, std::string>> ambiguous_with;  // effect, where; of every cause
  std::vector<DofView> dofs;
  bool free = true;  // simulated freely; else what the waveforms show is the force that a rig needs
  std::vector<LinkView> links;
  std::vector<Candidate> candidates;
  std::string score_name = "score";  // heading of Candidate::score
  std::vector<ParameterChange> parameters;
  std::vector<DofGain> gains;
  std::vector<Detectable> minimum_detectable;
  std::vector<std::string> advice;
  RigViews views;
  std::optional<data_check::Report> check;
};

struct EstimateReportData {
  std::string rig_name;
  std::vector<std::string> files, facts, notes;
  std::vector<ParameterChange> parameters;  // `after` is the estimate
  std::vector<std::string> advice;          // what to measure next
  std::vector<DofView> dofs;
  bool free = true;  // simulated freely; else what the waveforms show is the force that the rig needs
  RigViews views;
  std::optional<WarrantView> warrant;
  std::optional<data_check::Report> check;
};

}  // namespace host_sim::reports

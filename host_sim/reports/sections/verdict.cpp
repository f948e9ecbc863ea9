#include "host_sim/reports/sections/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <vector>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/sections/at_fault.hpp"
#include "host_sim/reports/sections/verdict_asides.hpp"
#include "host_sim/vocabulary/said.hpp"

namespace host_sim::reports {
namespace {

// "With it the simulation error on unseen data falls by a factor of 5.2." where it is known and a gain.
std::string gain_text(const std::vector<DofGain>& gains) {
  double best = 0.0;
  for (const DofGain& gain : gains)
    if (std::isfinite(gain.nrmse_before_percent) && gain.nrmse_after_percent > 0.0)
      best = std::max(best, gain.nrmse_before_percent / gain.nrmse_after_percent);
  if (best < 1.05) return "";
  char out[112];
  std::snprintf(out, sizeof out,
                "With this taken into account, the simulation's error on unseen data is %.*f times smaller.",
                best < 10.0 ? 1 : 0, best);
  return out;
}

// "5.7 % of the signal of DOF 1": the largest share that the simulation misses on unseen data, as given or extended.
std::string missed_text(const std::vector<DofGain>& gains, bool extended) {
  double most = 0.0;
  int dof = 0;
  for (const DofGain& gain : gains) {
    const double missed = extended ? gain.nrmse_after_percent : gain.nrmse_before_percent;
    if (std::isfinite(missed) && missed > most) most = missed, dof = gain.dof;
  }
  if (dof == 0) return "";
  char out[64];
  if (most > 100.0)
    std::snprintf(out, sizeof out, "more than the whole signal of DOF %d", dof);
  else
    std::snprintf(out, sizeof out, most < 10.0 ? "%.2g %% of the signal of DOF %d" : "%.0f %% of the signal of DOF %d",
                  most, dof);
  return out;
}

// A number of the rig file that is off: it has that error, which everything else is that it lacks.
bool is_error(const std::string& effect) { return effect == "mass_error" || effect == "stiffness_error"; }

struct Named {
  std::vector<std::string> lacks, errors, faults;  // of the rig file; of sensors and drives
  AtFault at_fault;
  size_t effects() const { return lacks.size() + errors.size(); }
};
Named named_in(const std::vector<Cause>& causes) {
  Named named;
  for (const Cause& cause : causes) {
    const std::string text = cause_text(cause.effect, cause.where);
    if (named.at_fault.add(cause.effect, cause.where))
      named.faults.push_back(text);
    else if (is_error(cause.effect))
      named.errors.push_back("a " + text);
    else
      named.lacks.push_back(text);
  }
  return named;
}

// "lacks backlash on link 1-2 and has a mass error on DOF 2"
std::string lacks_text(const std::string& lacks, const std::string& errors) {
  return (lacks.empty() ? "" : "lacks " + lacks) + (lacks.empty() || errors.empty() ? "" : " and ") +
         (errors.empty() ? "" : "has " + errors);
}

// The first of them, what it lacks before what it has.
std::string first_text(const Named& named) {
  return named.lacks.empty() ? lacks_text("", named.errors.front()) : lacks_text(named.lacks.front(), "");
}

// A headline names two causes at most.
std::string few(const std::vector<std::string>& items) {
  if (items.size() <= 2) return listed(items, "and");
  return items.front() + " and " + std::to_string(items.size() - 1) + " more";
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string headline_of_causes(const Named& named) {
  const size_t effects = named.effects();
  if (effects == 0) return capitalised(at_fault_text(named.at_fault)) + ": " + few(named.faults);
  if (named.faults.empty() && effects <= 2)
    return "The rig file " + lacks_text(listed(named.lacks, "and"), listed(named.errors, "and"));
  return "The rig file " + first_text(named) + (effects > 1 ? " and " + std::to_string(effects - 1) + " more" : "") +
         (named.faults.empty() ? "" : "; " + at_fault_text(named.at_fault));
}

// What the headline had no room for.
std::string rest_of_causes(const Named& named) {
  std::string out;
  const bool both = !named.faults.empty() && named.effects() > 0;
  if (named.effects() > (both ? 1u : 2u))
    out += "It " + lacks_text(listed(named.lacks, "and"), listed(named.errors, "and")) + ".";
  if (both || named.faults.size() > 2)
    out += (out.empty() ? "At fault: " : " At fault: ") + listed(named.faults, "and") + ".";
  return out;
}

struct Possible {
  std::vector<std::string> all;
  AtFault at_fault;
};
Possible possible_in(const DiagnosisReportData& data) {
  Possible out;
  const auto add = [&](const std::string& effect, const std::string& where) {
    const std::string text = cause_text(effect, where);
    if (std::find(out.all.begin(), out.all.end(), text) != out.all.end()) return;
    out.all.push_back(text), out.at_fault.add(effect, where);
  };
  for (const Cause& cause : data.causes) add(cause.effect, cause.where);
  for (const auto& other : data.ambiguous_with) add(other.first, other.second);
  return out;
}

// Of several causes those that no other could replace, and of each of the others what it may be.
struct Told {
  std::vector<Cause> sure;
  std::vector<std::string> open;
};
Told told_in(const DiagnosisReportData& data) {
  Told told;
  for (const Cause& cause : data.causes) {
    if (cause.rivals.empty()) {
      told.sure.push_back(cause);
      continue;
    }
    std::vector<std::string> all{cause_text(cause.effect, cause.where)};
    for (const auto& [effect, where] : cause.rivals) all.push_back(cause_text(effect, where));
    told.open.push_back("one of these: " + listed(all, "or"));
  }
  return told;
}

std::string joined(std::initializer_list<std::string> sentences) {
  std::string out;
  for (const std::string& sentence : sentences)
    if (!sentence.empty()) out += (out.empty() ? "" : " ") + sentence;
  return out;
}

}  // namespace

std::string cause_text(const std::string& effect, const std::string& where) {
  if (effect == kForceHold) return "a hold of the force between samples (" + where + ")";
  return vocabulary::said(effect, where);
}

namespace {

std::string ambiguous_details(const DiagnosisReportData& data) {
  const Told told = told_in(data);
  const std::string remains = data.more_remains ? "Something beyond noise remains with each of them." : "";
  if (data.causes.size() < 2 || told.open.empty())
    return joined({"It is one of these: " + listed(possible_in(data).all, "or") + ".", remains});
  const std::string missed = missed_text(data.gains, true);
  return joined({rest_of_causes(named_in(told.sure)), "There is " + listed(told.open, "and") + ".",
                 gain_text(data.gains), missed.empty() ? "" : "It still misses " + missed + ".", remains});
}

// What may be there and was not named, two at most.
std::string possible_text(const DiagnosisReportData& data) {
  std::vector<std::string> words;
  for (const PossibleCause& c : data.possible) {
    const std::string word = cause_text(c.effect, c.where);  // shapes of one effect have one
    if (words.size() < 2 && std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
  }
  return listed(words, "or");
}

constexpr double kMuchMissed_percent = 25;  // as far as a run is in phase

// Windows are followed and a run over all that is unseen is not: a sentence beside "explains".
std::string free_run_text(const DiagnosisReportData& data) {
  const bool astray = !data.leaves_noise_alone &&
                      std::any_of(data.gains.begin(), data.gains.end(),
                                  [](const DofGain& g) { return g.nrmse_before_percent > kMuchMissed_percent; });
  const std::string missed = astray ? missed_text(data.gains, false) : "";
  return missed.empty() ? ""
                        : "Followed stretch by stretch, that is: a free run over all unseen data misses " + missed +
                              ", as small errors of the start and of the numbers grow in it.";
}

// What explains the measurement with a number that cannot be has another law in its place.
std::string impossible_text(const DiagnosisReportData& data) {
  const auto number = std::find_if(data.parameters.begin(), data.parameters.end(),
                                   [](const ParameterChange& p) { return p.impossible; });
  if (number == data.parameters.end()) return "";
  return "It does so with " + number->name + " below nought, which cannot be: another law has its place.";
}

// Of a rig file that explains the measurement.
std::string rest_text(const DiagnosisReportData& data) {
  const auto bends =
      std::find_if(data.possible.begin(), data.possible.end(), [](const auto& c) { return !c.bends.empty(); });
  if (bends != data.possible.end())
    return "What is left beyond measurement noise may be " + possible_text(data) +
           ", though too little of it to be sure; " + bends->bends + " would then be " + bends->to + ".";
  if (data.more_remains)
    return "What is left is no noise, though no effect of the vocabulary is borne out by it: a force that is missing "
           "may be in the numbers.";
  return data.leaves_noise_alone
             ? "Nothing is left beyond measurement noise that these data could show."
             : "What is left beyond measurement noise neither helps to predict unseen data nor moves a coefficient.";
}

std::string nothing_explains_text(const DiagnosisReportData& data) {
  const std::string none = "No effect in the vocabulary explains what is left";
  if (data.possible.empty()) return none + ".";
  char share[64];
  std::snprintf(share, sizeof share, ", which takes %.0f %% of it.", data.possible.front().explains_percent);
  return none + "; nearest comes " + cause_text(data.possible.front().effect, data.possible.front().where) + share;
}

}  // namespace

bool tells_nothing(const DiagnosisReportData& data) {
  if (data.determines_nothing) return true;
  return data.noise_hides && !data.parameters.empty() &&
         std::all_of(data.parameters.begin(), data.parameters.end(),
                     [](const ParameterChange& p) { return p.status == "ILL_CONDITIONED"; });
}

std::string verdict_headline(const DiagnosisReportData& data) {
  if (tells_nothing(data)) return "These records do not tell whether the rig file is right";
  if (data.verdict == "none") return "The rig file explains the measurement";
  if (data.verdict == "ambiguous") {
    const Told told = told_in(data);
    if (!told.sure.empty() && !told.open.empty())
      return headline_of_causes(named_in(told.sure)) + ", and something that these data cannot tell";
    const Possible possible = possible_in(data);
    const size_t faults = possible.at_fault.all();
    if (faults == 0) return "The rig file lacks something, and these data cannot tell which";
    if (faults < possible.all.size()) return "The rig file lacks something or " + one_at_fault_text(possible.at_fault);
    return capitalised(one_at_fault_text(possible.at_fault)) + ", and these data cannot tell which";
  }
  if (!data.cannot_describe.empty()) return "The rig file cannot describe this recording";
  if (data.causes.empty() && !data.odd_record.empty()) return "The rig file does not explain all of the records";
  if (data.noise_hides) return "The data are too noisy to tell whether the rig file is right";
  if (data.causes.empty()) return "The rig file does not explain the measurement";
  return headline_of_causes(named_in(data.causes));
}

namespace {

std::string details_of(const DiagnosisReportData& data) {
  if (tells_nothing(data)) {
    const std::string missed = missed_text(data.gains, false);
    return joined(
        {"They determine none of its coefficients, and beside numbers that may be anything nothing that is missing can "
         "be seen.",
         missed.empty() ? "" : "Its simulation misses " + missed + " on unseen data."});
  }
  if (data.verdict == "none") return joined({rest_text(data), impossible_text(data), free_run_text(data)});
  if (data.verdict == "ambiguous") return ambiguous_details(data);
  if (!data.cannot_describe.empty()) return data.cannot_describe;
  const std::string missed = missed_text(data.gains, !data.causes.empty());
  if (data.causes.empty() && !data.odd_record.empty()) return "";
  if (data.causes.empty())
    return joined({missed.empty() ? "" : "Its simulation misses " + missed + " on unseen data.",
                   data.noise_hides ? "What is left is no more than the noise of the channels makes of it."
                                    : nothing_explains_text(data)});
  const std::string remains = missed.empty() ? "What remains" : "What remains, " + missed + ",";
  const std::string remainder = data.verdict == "partly" ? remains + " is beyond noise; its cause is not known."
                                : data.verdict == "unknown"
                                    ? remains + " is beyond noise, and no effect in the vocabulary explains it."
                                    : "";
  return joined({rest_of_causes(named_in(data.causes)), gain_text(data.gains), remainder});
}

}  // namespace

std::string verdict_details(const DiagnosisReportData& data) {
  return joined({data.odd_record, details_of(data), left_out_text(data), later_start_text(data),
                 along_motion_text(data), one_friction_text(data)});
}

std::string verdict_sentence(const DiagnosisReportData& data) {
  return joined({verdict_headline(data) + ".", verdict_details(data)});
}

}  // namespace host_sim::reports

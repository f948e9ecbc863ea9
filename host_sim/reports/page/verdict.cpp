#include "host_sim/reports/page/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace host_sim::reports {
namespace {

std::string listed(const std::vector<std::string>& items, const char* last_word) {
  std::string out;
  for (size_t i = 0; i < items.size(); ++i)
    out += (i == 0 ? "" : i + 1 == items.size() ? std::string(" ") + last_word + " " : ", ") + items[i];
  return out;
}

// "; with it the simulation error on unseen data falls by a factor of 5.2" where it is known and a gain.
std::string gain_text(const std::vector<DofGain>& gains, const char* with) {
  double best = 0.0;
  for (const DofGain& gain : gains)
    if (std::isfinite(gain.nrmse_before_percent) && gain.nrmse_after_percent > 0.0)
      best = std::max(best, gain.nrmse_before_percent / gain.nrmse_after_percent);
  if (best < 1.05) return "";
  char out[112];
  std::snprintf(out, sizeof out, "; with %s the simulation error on unseen data falls by a factor of %.*f", with,
                best < 10.0 ? 1 : 0, best);
  return out;
}

bool of_channel(const std::string& where) { return where.rfind("channel ", 0) == 0; }

// What the rig file lacks, what is wrong with the measurement, or both.
std::string named(const DiagnosisReportData& data) {
  std::vector<std::string> effects, faults;
  for (const Cause& cause : data.causes)
    (of_channel(cause.where) ? faults : effects).push_back(cause_text(cause.effect, cause.where));
  const std::string fault = faults.size() > 1 ? "sensors are at fault: " : "a sensor is at fault: ";
  if (faults.empty()) return "The rig file lacks " + listed(effects, "and") + gain_text(data.gains, "it");
  if (effects.empty())
    return (faults.size() > 1 ? "Sensors are at fault: " : "A sensor is at fault: ") + listed(faults, "and") +
           gain_text(data.gains, "that corrected");
  return "The rig file lacks " + listed(effects, "and") + ", and " + fault + listed(faults, "and") +
         gain_text(data.gains, "both");
}

// The same where the data leave it open.
std::string one_of(const std::vector<Cause>& causes, const std::vector<std::pair<std::string, std::string>>& others) {
  std::vector<std::string> all;
  size_t faults = 0;
  const auto add = [&](const std::string& effect, const std::string& where) {
    const std::string text = cause_text(effect, where);
    if (std::find(all.begin(), all.end(), text) != all.end()) return;
    all.push_back(text), faults += of_channel(where);
  };
  for (const Cause& cause : causes) add(cause.effect, cause.where);
  for (const auto& other : others) add(other.first, other.second);
  const char* what = faults == 0            ? "The rig file lacks something"
                     : faults == all.size() ? "A sensor is at fault"
                                            : "The rig file lacks something or a sensor is at fault";
  return what + std::string(", and these data cannot tell which: ") + listed(all, "or") + ".";
}

}  // namespace

std::string cause_text(const std::string& effect, const std::string& where) {
  std::string words = effect;
  std::replace(words.begin(), words.end(), '_', ' ');
  return where.empty() ? words
                       : words + (of_channel(where) ? " in " : " on ") +
                             (where.rfind("dof ", 0) == 0 ? "DOF" + where.substr(3) : where);
}

std::string verdict_sentence(const DiagnosisReportData& data) {
  if (data.verdict == "none")
    return "The rig file explains the measurement: nothing is left beyond measurement noise that these data could "
           "show.";
  if (data.verdict == "explained") return named(data) + ".";
  if (data.verdict == "ambiguous") return one_of(data.causes, data.ambiguous_with);
  if (data.verdict == "partly") return named(data) + ". What remains is beyond noise, its cause not known.";
  if (data.causes.empty())
    return "The rig file does not explain the measurement, and no effect in the vocabulary explains what is left.";
  return named(data) + ". A residual beyond noise remains that no effect in the vocabulary explains.";
}

}  // namespace host_sim::reports

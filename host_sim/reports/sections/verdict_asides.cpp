#include "host_sim/reports/sections/verdict_asides.hpp"

#include <algorithm>

#include "host_sim/reports/figures/numbers.hpp"

namespace host_sim::reports {

std::string listed(const std::vector<std::string>& items, const char* last_word) {
  std::string out;
  for (size_t i = 0; i < items.size(); ++i)
    out += (i == 0 ? "" : i + 1 == items.size() ? std::string(" ") + last_word + " " : ", ") + items[i];
  return out;
}

std::string left_out_text(const DiagnosisReportData& data) {
  const std::vector<std::string>& names = data.channels_left_out;
  if (names.empty()) return "";
  return "This is said without " + listed(names, "and") + (names.size() == 1 ? ", which does" : ", which do") +
         " not go with the other channels of the same place: with " + (names.size() == 1 ? "it" : "them") +
         " nothing explains the records. Look at " + (names.size() == 1 ? "its sensor." : "these sensors.");
}

std::string later_start_text(const DiagnosisReportData& data) {
  if (data.told_from_s.empty()) return "";
  std::vector<std::string> instants;
  for (double s : data.told_from_s) instants.push_back(number_text(s, 3));
  return "This is said of the motion from " + listed(instants, "and") +
         " s on: before, something acts that the rig file has not (a hand that still holds or pulls, faster modes of a "
         "blow, a law that larger motion alone shows).";
}

std::string along_motion_text(const DiagnosisReportData& data) {
  if (!data.along_motion) return "";
  return "This is said of the forces along the motion as measured: no spring holds the rig, and its free runs do not "
         "follow what "
         "something else holds (a controller, a hand). So percents are of the forces.";
}

std::string one_friction_text(const DiagnosisReportData& data) {
  const std::string of_link = "link ";
  for (const Cause& cause : data.causes) {
    if (cause.effect != "presliding_hysteresis" || cause.where.find(of_link) != 0) continue;
    const std::string link = "[" + cause.where.substr(of_link.size()) + "]", own = "coulomb" + link;
    const auto is_own = [&](const ParameterChange& p) { return p.name == own; };
    if (std::any_of(data.parameters.begin(), data.parameters.end(), is_own))
      return own + " and presliding_hysteresis" + link + " are one friction, and its number stands under both names.";
  }
  return "";
}

}  // namespace host_sim::reports

#include "host_sim/programs/diagnose/diagnosis_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/programs/shared/terminal.hpp"
#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/sections/verdict.hpp"

namespace host_sim {
namespace {

using Row = std::vector<std::string>;

// Characters of UTF-8 text, for columns that line up.
size_t width_of(const std::string& text) {
  return static_cast<size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

// Units as every other table spells them ("N s/m^2"): the pages' raised digits and dots are for browsers.
std::string plain_units(const std::string& text) {
  static const std::pair<const char*, const char*> kPlain[] = {{"·", " "},  {"²", "^2"}, {"³", "^3"},
                                                               {"⁴", "^4"}, {"⁵", "^5"}, {"–", "-"}};
  std::string out = text;
  for (const auto& [pretty, plain] : kPlain)
    for (size_t at = 0; (at = out.find(pretty, at)) != std::string::npos; at += std::string(plain).size())
      out.replace(at, std::string(pretty).size(), plain);
  return out;
}

std::string table(std::vector<Row> rows) {
  std::vector<size_t> widths;
  for (Row& row : rows) {
    for (std::string& cell : row) cell = plain_units(cell);
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  }
  std::string out;
  for (const Row& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) line += row[i] + std::string(widths[i] + 2 - width_of(row[i]), ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    out += "  " + line + "\n";
  }
  return out;
}

std::string interval_text(const reports::Interval& interval) {
  if (!std::isfinite(interval.value)) return "-";
  const int digits = reports::digits_for(interval);
  std::string out = reports::number_text(interval.value, digits);
  if (std::isfinite(interval.low))
    out +=
        " (" + reports::number_text(interval.low, digits) + " to " + reports::number_text(interval.high, digits) + ")";
  return out;
}

std::string parameters_text(const reports::DiagnosisReportData& data) {
  std::vector<Row> rows = {{"parameter", "unit", "rig as given (95 %)", "extended rig (95 %)", "status"}};
  for (const reports::ParameterChange& parameter : data.parameters)
    rows.push_back({parameter.name, parameter.unit, interval_text(parameter.before), interval_text(parameter.after),
                    parameter.status});
  if (data.causes.empty())
    for (Row& row : rows) row.erase(row.begin() + 3);
  return rows.size() > 1 ? "\n" + table(rows) : "";
}

std::string gains_text(const reports::DiagnosisReportData& data) {
  std::vector<Row> rows = {{"held-out simulation", "NRMSE, %", "extended", "gain", "MSE, %", "extended"}};
  for (const reports::DofGain& gain : data.gains)
    rows.push_back({"DOF " + std::to_string(gain.dof), reports::missed_text(gain.nrmse_before_percent),
                    reports::missed_text(gain.nrmse_after_percent),
                    reports::number_text(gain.nrmse_before_percent / gain.nrmse_after_percent, 3),
                    reports::missed_text(gain.mse_before_percent), reports::missed_text(gain.mse_after_percent)});
  return rows.size() > 1 ? "\n" + table(rows) : "";
}

std::string limits_text(const reports::DiagnosisReportData& data) {
  if (data.verdict != "none" || data.minimum_detectable.empty()) return "";
  std::vector<Row> rows = {{"would have been seen from", "", "", "of the link's damping force"}};
  for (const reports::Detectable& limit : data.minimum_detectable) {
    const double percent = limit.percent_of_damping_force;
    rows.push_back({reports::cause_text(limit.effect, limit.where), reports::number_text(limit.strength, 2),
                    std::isfinite(limit.strength) ? reports::unit_text(limit.unit) : "not in these data",
                    std::isfinite(percent) ? reports::percent_text(percent) + " %" : ""});
  }
  return "\n" + table(rows);
}

}  // namespace

std::string diagnosis_text(const reports::DiagnosisReportData& data, bool colours, int width) {
  const bool sure = data.verdict == "none" || data.verdict == "explained";
  const std::string verdict = wrapped(data.verdict + ": " + reports::verdict_sentence(data), width, "  ");
  std::string out = data.rig_name + "\n" + coloured(data.verdict, sure ? Colour::kGood : Colour::kDoubtful, colours) +
                    verdict.substr(data.verdict.size()) + "\n";
  for (const reports::Cause& cause : data.causes)
    for (const std::string& parameter : cause.parameters) out += "  " + wrapped(parameter, width, "    ") + "\n";
  out += parameters_text(data) + gains_text(data) + limits_text(data);
  if (!data.advice.empty()) out += "\nWhat to measure next:\n";
  for (const std::string& advice : data.advice) out += "  - " + wrapped(advice, width - 2, "    ") + "\n";
  return plain_units(out) + "\n";
}

}  // namespace host_sim

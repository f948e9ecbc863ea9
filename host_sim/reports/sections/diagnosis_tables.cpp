#include "host_sim/reports/sections/diagnosis_tables.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/sections/verdict.hpp"

namespace host_sim::reports {
namespace {

// Takes columns [first, end) out.
void without_columns(HtmlTable& table, std::ptrdiff_t first, std::ptrdiff_t end) {
  const auto cut = [&](auto& list) { list.erase(list.begin() + first, list.begin() + end); };
  cut(table.heading);
  cut(table.numeric);
  for (auto& row : table.rows) cut(row);
}

}  // namespace

void add_gain(Page& page, const DiagnosisReportData& data) {
  if (data.gains.empty()) return;
  const bool any_extended = std::any_of(data.gains.begin(), data.gains.end(),
                                        [](const DofGain& gain) { return std::isfinite(gain.nrmse_after_percent); });
  page.section(
      "gain", any_extended ? "Gain on data that the fit has not seen" : "Error on data that the fit has not seen",
      data.along_motion
          ? "Balance of forces along the motion as measured. NRMSE is of the force (torque), MSE its square."
          : "Free-running simulation under the measured force from the measured initial state. NRMSE is of the "
            "displacement (angle), MSE of the acceleration (Eq. 13 of the paper).");
  double worst = 0.0;
  for (const DofGain& gain : data.gains)
    for (double value : {gain.nrmse_before_percent, gain.nrmse_after_percent})
      if (std::isfinite(value)) worst = std::max(worst, value);
  HtmlTable table;
  table.heading = {"DOF", "rig", "NRMSE, %", "", "MSE, %", "gain"};
  table.numeric = {false, false, true, false, true, true};
  for (const DofGain& gain : data.gains) {
    const bool extended = std::isfinite(gain.nrmse_after_percent);
    table.rows.push_back({std::to_string(gain.dof), "as given", missed_html(gain.nrmse_before_percent),
                          bar_html(gain.nrmse_before_percent / worst, role_variable(Role::kGiven)),
                          missed_html(gain.mse_before_percent), ""});
    if (extended)
      table.rows.push_back({"", "extended", missed_html(gain.nrmse_after_percent),
                            bar_html(gain.nrmse_after_percent / worst, role_variable(Role::kExtended)),
                            missed_html(gain.mse_after_percent),
                            "<b>" + number_html(gain.nrmse_before_percent / gain.nrmse_after_percent, 3) + " ×</b>"});
  }
  if (!any_extended) without_columns(table, 5, 6);
  page.html(table_html(table));
}

void add_parameters(Page& page, const DiagnosisReportData& data) {
  if (data.parameters.empty()) return;
  const bool extended = !data.causes.empty();
  page.section("parameters", extended ? "Parameters before and after" : "Parameters", "In brackets the 95 % interval.");
  HtmlTable table;
  table.heading = {"parameter", "unit", "rig as given", "extended rig", "change", "status"};
  table.numeric = {false, false, true, true, true, false};
  for (const ParameterChange& parameter : data.parameters) {
    const double change = 100.0 * (parameter.after.value / parameter.before.value - 1.0);
    table.rows.push_back({"<code>" + escaped(parameter.name) + "</code>", escaped(unit_text(parameter.unit)),
                          interval_html(parameter.before), interval_html(parameter.after),
                          std::isfinite(change) ? number_html(change, 3) + " %" : "", status_html(parameter.status)});
  }
  if (!extended) without_columns(table, 3, 5);
  page.html(table_html(table));
}

void add_candidates(Page& page, const DiagnosisReportData& data) {
  if (data.candidates.empty()) return;
  page.section("candidates", "Candidates, ranked",
               "Every effect of the vocabulary was tried on every link, DOF and channel; the best are listed.");
  double best = 0.0;
  bool any_threshold = false;
  for (const Candidate& candidate : data.candidates) {
    best = std::max(best, candidate.score);
    any_threshold = any_threshold || candidate.threshold > 0.0;
  }
  HtmlTable table;
  table.heading = {"", "effect", "where", escaped(data.score_name), "", "needed", "remark"};
  table.numeric = {true, false, false, true, false, true, false};
  for (size_t i = 0; i < data.candidates.size(); ++i) {
    const Candidate& candidate = data.candidates[i];
    const std::string open = candidate.chosen ? "<span class=\"chosen\">" : "<span>";
    table.rows.push_back({std::to_string(i + 1), open + escaped(cause_text(candidate.effect, "")) + "</span>",
                          escaped(candidate.where), number_html(candidate.score, 4),
                          bar_html(std::log1p(std::max(0.0, candidate.score)) / std::log1p(best),
                                   candidate.chosen ? role_variable(Role::kExtended) : "var(--frame)"),
                          candidate.threshold > 0.0 ? number_html(candidate.threshold, 3) : "",
                          candidate.chosen ? "<span class=\"good\">named</span>" : escaped(candidate.remark)});
  }
  if (!any_threshold) without_columns(table, 5, 6);
  page.html(table_html(table) + "<p class=\"dim\">The bars are logarithmic.</p>\n");
}

}  // namespace host_sim::reports

// The diagnosis page: verdict first, then what shows it, then what to do.
#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/page/data_sections.hpp"
#include "host_sim/reports/page/detectable_tables.hpp"
#include "host_sim/reports/page/diagnosis_pictures.hpp"
#include "host_sim/reports/page/report.hpp"
#include "host_sim/reports/page/rig_sections.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/page/verdict.hpp"
#include "host_sim/reports/page/zoom.hpp"

namespace host_sim::reports {
namespace {

std::string lead_html(const DiagnosisReportData& data) {
  const char* mood = data.verdict == "none" || data.verdict == "explained" ? "good" : "warn";
  std::vector<std::string> facts = {"rig: " + data.rig_name};
  for (const std::string& file : data.files) facts.push_back("data: " + file);
  facts.insert(facts.end(), data.facts.begin(), data.facts.end());
  const std::string details = verdict_details(data);
  return "<p><span class=\"badge " + std::string(mood) + "\">" + escaped(data.verdict) + "</span></p>\n" +
         (details.empty() ? "" : "<p class=\"lead\">" + escaped(details) + "</p>\n") + facts_html(facts);
}

void add_causes(Page& page, const DiagnosisReportData& data) {
  if (data.causes.empty()) return;
  page.html("<div class=\"cards\">\n");
  for (const Cause& cause : data.causes) {
    std::string card = "<div class=\"card\"><b>" + escaped(cause_text(cause.effect, cause.where)) + "</b>";
    if (std::isfinite(cause.explains_percent))
      card += "<p>explains " + number_html(cause.explains_percent, 3) + " % of what the rig as given leaves over</p>";
    else
      card += "<p>taken out of the record before the rig is judged</p>";
    for (const std::string& parameter : cause.parameters) card += "<p><code>" + escaped(parameter) + "</code></p>";
    page.html(card + "</div>\n");
  }
  page.html("</div>\n");
}

// Takes columns [first, end) out.
void without_columns(HtmlTable& table, std::ptrdiff_t first, std::ptrdiff_t end) {
  const auto cut = [&](auto& list) { list.erase(list.begin() + first, list.begin() + end); };
  cut(table.heading);
  cut(table.numeric);
  for (auto& row : table.rows) cut(row);
}

void add_gain(Page& page, const DiagnosisReportData& data) {
  if (data.gains.empty()) return;
  const bool any_extended = std::any_of(data.gains.begin(), data.gains.end(),
                                        [](const DofGain& gain) { return std::isfinite(gain.nrmse_after_percent); });
  page.section("gain",
               any_extended ? "Gain on data that the fit has not seen" : "Error on data that the fit has not seen",
               "Free-running simulation under the measured force from the measured initial state. NRMSE is of the "
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
    table.rows.push_back({std::to_string(gain.dof), "as given", number_html(gain.nrmse_before_percent, 3),
                          bar_html(gain.nrmse_before_percent / worst, role_variable(Role::kGiven)),
                          number_html(gain.mse_before_percent, 3), ""});
    if (extended)
      table.rows.push_back({"", "extended", number_html(gain.nrmse_after_percent, 3),
                            bar_html(gain.nrmse_after_percent / worst, role_variable(Role::kExtended)),
                            number_html(gain.mse_after_percent, 3),
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

void add_pictures(Page& page, const DiagnosisReportData& data) {
  page.section("waveforms", "Measured and simulated",
               std::string(data.causes.empty() ? "The rig as given" : "The rig as given and the extended rig") +
                   ", simulated freely under the measured force. Each row shows the moment where the rig as given is "
                   "most wrong, the errors over the whole record, and the spectra.");
  const size_t columns = picture_columns(data.dofs.size());
  for (const DofView& view : data.dofs)
    for (const Waveform& waveform : view.waveforms) page.figures(waveform_pictures(view, waveform, columns));
  const auto has_energy = [](const DofView& view) { return !view.energy.time_s.empty(); };
  if (std::any_of(data.dofs.begin(), data.dofs.end(), has_energy)) {
    page.section(
        "energy", "Energy balance",
        "What the drive puts into each DOF, where it goes, and what no term of the rig as given accounts for.");
    for (const DofView& view : data.dofs)
      if (has_energy(view)) page.figures(energy_pictures(view, energy_terms(data.dofs), columns));
  }
  if (data.links.empty()) return;
  page.section(
      "links", "Residual force of each link",
      "The force that the model of a link leaves unexplained, sorted by elongation and by rate (median and the "
      "range that holds 80 % of the samples), and over time (its range). A horizontal line at zero is a good model.");
  for (const LinkView& link : data.links) page.figures(link_pictures(link));
}

void add_detectable(Page& page, const DiagnosisReportData& data) {
  if (data.minimum_detectable.empty()) return;
  page.section(
      "detectable", "What would have been seen",
      "The smallest strength of each effect that these data would have shown in 95 % of cases. Anything weaker "
      "may be there; what no strength would show is marked as not in these data. Below it in percent: rms of the "
      "effect's force at that strength, over rms of what the dampers of the link (of a DOF: its strongest link) take.");
  for (const HtmlTable& table : detectable_tables(data.minimum_detectable)) page.html(table_html(table));
}

void add_advice(Page& page, const DiagnosisReportData& data) {
  if (data.advice.empty()) return;
  page.section("advice", "What to measure next", "");
  std::string list = "<ul class=\"advice\">";
  for (const std::string& advice : data.advice) list += "<li>" + escaped(advice) + "</li>";
  page.html(list + "</ul>\n");
}

}  // namespace

std::string diagnosis_page(const DiagnosisReportData& data) {
  Page page(verdict_headline(data), "Diagnosis of " + data.rig_name, lead_html(data));
  add_causes(page, data);
  add_advice(page, data);
  if (data.verdict == "none") add_detectable(page, data);
  add_gain(page, data);
  add_parameters(page, data);
  add_pictures(page, data);
  add_zoom(page, zoom_records(data.dofs));
  add_rig_sections(page, data.views);
  add_data_check(page, data.check);
  add_candidates(page, data);
  if (data.verdict != "none") add_detectable(page, data);
  return page.finish();
}

void write_diagnosis_report(const std::string& directory, const DiagnosisReportData& data) {
  write_index(directory, diagnosis_page(data));
}

}  // namespace host_sim::reports

// The diagnosis page: verdict first, then what shows it, then what to do.
#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/page/report.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/sections/data_sections.hpp"
#include "host_sim/reports/sections/detectable_tables.hpp"
#include "host_sim/reports/sections/diagnosis_pictures.hpp"
#include "host_sim/reports/sections/diagnosis_tables.hpp"
#include "host_sim/reports/sections/rig_sections.hpp"
#include "host_sim/reports/sections/verdict.hpp"
#include "host_sim/reports/zoom/zoom.hpp"

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

void add_pictures(Page& page, const DiagnosisReportData& data) {
  page.section("waveforms", "Measured and simulated",
               std::string(data.causes.empty() ? "The rig as given" : "The rig as given and the extended rig") + ", " +
                   how_simulated(data.free) +
                   ". Each row shows the moment where the rig as given is most wrong, the errors over the whole "
                   "record, and the spectra.");
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

Page made_page(const DiagnosisReportData& data) {
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
  return page;
}

}  // namespace

std::string diagnosis_page(const DiagnosisReportData& data) { return made_page(data).finish(); }

void write_diagnosis_report(const std::string& directory, const DiagnosisReportData& data) {
  write_page(directory, made_page(data));
}

}  // namespace host_sim::reports

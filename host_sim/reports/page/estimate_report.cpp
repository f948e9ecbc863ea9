// The page of an estimation: the coefficients first, then what the rig with them looks like beside the record.
#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/page/report.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/sections/data_sections.hpp"
#include "host_sim/reports/sections/diagnosis_pictures.hpp"
#include "host_sim/reports/sections/rig_sections.hpp"
#include "host_sim/reports/sections/verdict.hpp"
#include "host_sim/reports/zoom/zoom.hpp"

namespace host_sim::reports {
namespace {

// "4 of 5 coefficients are valid."
std::string sentence(const EstimateReportData& data) {
  size_t valid = 0;
  for (const ParameterChange& parameter : data.parameters) valid += parameter.status == "VALID";
  if (valid == data.parameters.size())
    return valid == 1 ? "The coefficient is valid" : "All " + std::to_string(valid) + " coefficients are valid";
  return std::to_string(valid) + " of " + std::to_string(data.parameters.size()) + " coefficients are valid";
}

void add_table(Page& page, const EstimateReportData& data) {
  page.section("estimates", "Coefficients", "In brackets the 95 % interval. Act on those marked VALID.");
  HtmlTable table;
  table.heading = {"parameter", "unit", "estimate", "status"};
  table.numeric = {false, false, true, false};
  for (const ParameterChange& parameter : data.parameters)
    table.rows.push_back({"<code>" + escaped(parameter.name) + "</code>", escaped(unit_text(parameter.unit)),
                          interval_html(parameter.after), status_html(parameter.status)});
  page.html(table_html(table));
}

void add_list(Page& page, const char* id, const char* heading, const std::vector<std::string>& items) {
  if (items.empty()) return;
  page.section(id, heading, "");
  std::string list;
  for (const std::string& item : items) list += "<li>" + escaped(item) + "</li>\n";
  page.html("<ul class=\"advice\">\n" + list + "</ul>\n");
}

Page made_page(const EstimateReportData& data) {
  std::vector<std::string> facts;
  for (const std::string& file : data.files) facts.push_back("data: " + file);
  facts.insert(facts.end(), data.facts.begin(), data.facts.end());
  std::string lead;
  if (data.warrant && !data.warrant->named.effect.empty())
    lead =
        "<p class=\"lead\">The data contradict the rig file. " +
        std::string(data.warrant->not_the_cause.empty() ? "Suspected: " : "No candidate explains it; the nearest: ") +
        escaped(cause_text(data.warrant->named.effect, data.warrant->named.where)) + ".</p>\n";
  Page page(sentence(data), "Estimation of " + data.rig_name, lead + facts_html(facts));
  add_table(page, data);
  add_warrant(page, data.warrant);
  add_list(page, "advice", "What to measure next", data.advice);
  add_list(page, "notes", "Notes", data.notes);
  if (!data.dofs.empty()) {
    page.section("waveforms", "Measured and simulated",
                 "The rig with the estimates, " + how_simulated(data.free) +
                     ": the moment where it is most wrong, the errors over the whole record, and the spectra.");
    const size_t columns = picture_columns(data.dofs.size());
    for (const DofView& view : data.dofs)
      for (const Waveform& waveform : view.waveforms) page.figures(waveform_pictures(view, waveform, columns));
  }
  add_zoom(page, zoom_records(data.dofs));
  add_rig_sections(page, data.views);
  add_data_check(page, data.check);
  return page;
}

}  // namespace

std::string estimate_page(const EstimateReportData& data) { return made_page(data).finish(); }

void write_estimate_report(const std::string& directory, const EstimateReportData& data) {
  write_page(directory, made_page(data));
}

}  // namespace host_sim::reports

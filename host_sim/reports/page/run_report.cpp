// The page of a simulated run: the counterparts of the paper's figures 2, 3 and 5 to 7, and each estimate as it
// converges.
#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/figures/reduce.hpp"
#include "host_sim/reports/page/report.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/sections/data_sections.hpp"
#include "host_sim/reports/sections/rig_sections.hpp"
#include "host_sim/reports/sections/run_pictures.hpp"
#include "host_sim/reports/zoom/zoom.hpp"

namespace host_sim::reports {
namespace {

bool inside(const RunParameter& parameter) {
  return parameter.truth >= parameter.estimate.low && parameter.truth <= parameter.estimate.high;
}

// "4 of 5 true values lie inside their 95 % interval"
std::string sentence(const RunReportData& data) {
  size_t known = 0, held = 0;
  for (const RunParameter& parameter : data.parameters) {
    if (!std::isfinite(parameter.truth)) continue;
    ++known;
    held += inside(parameter);
  }
  if (known == 0) return std::to_string(data.parameters.size()) + " parameters estimated";
  return std::to_string(held) + " of " + std::to_string(known) + " true values lie inside their 95 % interval";
}

// "the worst estimate is off by 0.6 %"; empty where no truth is known.
std::string worst_error(const RunReportData& data) {
  double worst = -1.0;
  for (const RunParameter& parameter : data.parameters)
    if (std::isfinite(parameter.truth) && parameter.truth != 0.0)
      worst = std::max(worst, std::abs(parameter.estimate.value / parameter.truth - 1.0));
  if (worst < 0.0) return "";
  return worst < 1e-6 ? "the worst estimate is off by less than 0.0001 %"
                      : "the worst estimate is off by " + number_text(100.0 * worst, 2) + " %";
}

void add_table(Page& page, const RunReportData& data) {
  page.section("estimates", "Truth and estimate", "In brackets the 95 % interval.");
  HtmlTable table;
  table.heading = {"parameter", "unit", "truth", "estimate", "error, %", "truth inside", "status"};
  table.numeric = {false, false, true, true, true, false, false};
  for (const RunParameter& parameter : data.parameters) {
    const bool known = std::isfinite(parameter.truth);
    table.rows.push_back({"<code>" + escaped(parameter.name) + "</code>", escaped(unit_text(parameter.unit)),
                          number_html(parameter.truth, 5), interval_html(parameter.estimate),
                          known ? number_html(100.0 * (parameter.estimate.value / parameter.truth - 1.0), 2) : "",
                          !known              ? ""
                          : inside(parameter) ? "<span class=\"good\">yes</span>"
                                              : "<span class=\"warn\">no</span>",
                          status_html(parameter.status)});
  }
  page.html(table_html(table));
}

Page made_page(const RunReportData& data) {
  std::vector<std::string> facts = data.facts;
  if (const std::string worst = worst_error(data); !worst.empty()) facts.insert(facts.begin(), worst);
  if (std::isfinite(data.condition_number))
    facts.push_back("condition number " + number_text(data.condition_number, 3));
  if (std::isfinite(data.residual_mean_abs))
    facts.push_back("mean normalised residual " + number_text(data.residual_mean_abs, 3));
  Page page(sentence(data), "Run of " + data.scenario, facts_html(facts));
  add_table(page, data);
  add_warrant(page, data.warrant);
  std::vector<Plot> convergence;
  for (const RunParameter& parameter : data.parameters)
    if (!parameter.convergence.time_s.empty()) convergence.push_back(convergence_picture(parameter));
  if (!convergence.empty()) {
    page.section("convergence", "Each estimate, converging inside its interval",
                 "As the windows close. What the first windows say beyond the frame is cut off.");
    page.figures(convergence);
  }
  page.section(
      "signals", "Clean and contaminated signals",
      "The first cycles of every force, and of each DOF's displacement (its velocity or acceleration where that is "
      "what is measured): what the rig does, and what the estimator is given (the counterpart of Figures 2 and 6 of "
      "the paper).");
  for (const RunRecord& record : data.records) add_signals(page, record);
  page.section("accelerations", "Acceleration of each DOF",
               "The rig's own, and simulated with the estimates in place of the true values (Figures 3, 5 and 7).");
  for (const RunRecord& record : data.records) add_accelerations(page, record);
  std::vector<ZoomRecord> closer;
  for (const RunRecord& record : data.records)
    for (ZoomRecord& one : zoom_records(record)) closer.push_back(std::move(one));
  add_zoom(page, closer);
  add_rig_sections(page, data.views);
  add_data_check(page, data.check);
  return page;
}

}  // namespace

std::string run_page(const RunReportData& data) { return made_page(data).finish(); }

void write_run_report(const std::string& directory, const RunReportData& data) {
  write_page(directory, made_page(data));
}

}  // namespace host_sim::reports

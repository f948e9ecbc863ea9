// The page of a simulated run: the counterparts of the paper's figures 2, 3 and 5 to 7, and each estimate as it
// converges.
#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/figures/reduce.hpp"
#include "host_sim/reports/page/data_sections.hpp"
#include "host_sim/reports/page/report.hpp"
#include "host_sim/reports/page/rig_sections.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/page/zoom.hpp"

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

// The vertical range of a convergence plot follows its later half: the first windows, and often the whole first level,
// know next to nothing.
Plot convergence_picture(const RunParameter& parameter) {
  const Convergence& run = parameter.convergence;
  Plot plot;
  plot.title = parameter.name;
  plot.x_label = "time";
  plot.x_unit = "s";
  plot.y_label = parameter.name;
  plot.y_unit = parameter.unit;
  plot.scale_units = false;
  double low = parameter.estimate.value, high = parameter.estimate.value;
  const auto widen = [&](double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  widen(parameter.truth);
  for (size_t i = run.time_s.size() / 2; i < run.time_s.size(); ++i) {
    widen(run.low[i]);
    widen(run.high[i]);
  }
  const double air = 0.3 * (high - low);
  const auto cut = [&](double value) { return std::clamp(value, low - air, high + air); };
  Curve band, line, truth;
  band.label = "95 % interval";
  line.label = "estimate";
  truth.label = "truth";
  band.shape = Shape::kBand;
  truth.shape = Shape::kDashed;
  band.role = line.role = Role::kGiven;
  truth.role = Role::kTruth;
  for (size_t i = 0; i < run.time_s.size(); ++i) {
    band.x.push_back(run.time_s[i]);
    band.y.push_back(cut(run.low[i]));
    band.y_high.push_back(cut(run.high[i]));
    line.y.push_back(cut(run.value[i]));
  }
  line.x = band.x;
  if (std::isfinite(parameter.truth) && !band.x.empty()) {
    truth.x = {band.x.front(), band.x.back()};
    truth.y = {parameter.truth, parameter.truth};
  }
  plot.curves = {band, line, truth};
  if (truth.x.empty()) plot.curves.pop_back();
  return plot;
}

Plot pair_picture(const RunRecord& record, const std::string& title, const std::string& label, const std::string& unit,
                  const std::vector<double>& a, const std::vector<double>& b, Span span) {
  Plot plot;
  plot.title = title;
  plot.x_label = "time";
  plot.x_unit = "s";
  plot.y_label = label;
  plot.y_unit = unit;
  Curve first = envelope_line(a, span, record.start_s, record.period_s, kColumns);
  Curve second = envelope_line(b, span, record.start_s, record.period_s, kColumns);
  plot.curves = {first, second};
  return plot;
}

void add_signals(Page& page, const RunRecord& record) {
  if (record.channels.empty()) return;
  const Span span = most_different(record.channels.front().clean, {}, kDetailCycles);
  std::vector<Plot> plots;
  for (const RunChannel& channel : record.channels) {
    Plot plot = pair_picture(record, channel.name, channel.name.substr(0, channel.name.find(" of ")), channel.unit,
                             channel.contaminated, channel.clean, span);
    plot.curves[0].role = Role::kMeasured;
    plot.curves[0].label = "contaminated: what the sensors deliver";
    plot.curves[1].role = Role::kTruth;
    plot.curves[1].label = "clean: what the rig does";
    plots.push_back(plot);
  }
  page.html("<h3>" + escaped(record.label) + "</h3>\n");
  page.figures(plots);
}

void add_accelerations(Page& page, const RunRecord& record) {
  std::vector<Plot> plots;
  for (const RunAcceleration& acceleration : record.accelerations) {
    const Span span = most_different(acceleration.measured, acceleration.simulated, kDetailCycles);
    Plot plot = pair_picture(record, "DOF " + std::to_string(acceleration.dof) + ", acceleration", "acceleration",
                             acceleration.unit, acceleration.measured, acceleration.simulated, span);
    plot.curves[0].label = "of the rig";
    plot.curves[0].role = Role::kTruth;
    plot.curves[1].label = "simulated with the estimates";
    plot.curves[1].role = Role::kGiven;
    plot.curves[1].shape = Shape::kDashed;
    plot.note = "MSE (Eq. 13, all levels together): " + number_text(acceleration.mse_percent, 3) +
                " %. Shown where the two differ most.";
    plots.push_back(plot);
  }
  if (plots.empty()) return;
  page.html("<h3>" + escaped(record.label) + "</h3>\n");
  page.figures(plots);
}

}  // namespace

std::string run_page(const RunReportData& data) {
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
      "The first cycles of every channel: what the rig does, and what the estimator is given (the counterpart of "
      "Figures 2 and 6 of the paper).");
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
  return page.finish();
}

void write_run_report(const std::string& directory, const RunReportData& data) {
  write_index(directory, run_page(data));
}

}  // namespace host_sim::reports

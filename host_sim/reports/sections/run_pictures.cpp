#include "host_sim/reports/sections/run_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/figures/reduce.hpp"
#include "host_sim/reports/page/shared_parts.hpp"

namespace host_sim::reports {
namespace {

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

}  // namespace

// The vertical range of a convergence plot follows its later half: the first windows, and often the whole first level,
// know next to nothing: they are cut off at the frame, not moved into it.
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
  plot.y_low = low - air, plot.y_high = high + air;
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
    band.y.push_back(run.low[i]);
    band.y_high.push_back(run.high[i]);
    line.y.push_back(run.value[i]);
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

}  // namespace host_sim::reports

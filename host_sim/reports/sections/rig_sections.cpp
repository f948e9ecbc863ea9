#include "host_sim/reports/sections/rig_sections.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/page/shared_parts.hpp"

namespace host_sim::reports {
namespace {

// Interval of a damping ratio in percent.
Interval percent(const Interval& share) { return {100.0 * share.value, 100.0 * share.low, 100.0 * share.high}; }

std::string shape_html(const std::vector<double>& shape) {
  std::string out;
  for (double value : shape) out += (out.empty() ? "" : " &nbsp; ") + number_html(value, 2);
  return out;
}

void add_modes(Page& page, const std::vector<ModeRow>& modes) {
  if (modes.empty()) return;
  const bool intervals = std::isfinite(modes.front().frequency_Hz.low);
  page.section("modes", "Natural frequencies, damping ratios, mode shapes",
               std::string("Of the estimated rig's linear part: masses, springs and viscous dampers. Coulomb friction "
                           "adds damping that depends on the amplitude and is not in these ratios.") +
                   (intervals ? " In brackets the 95 % interval that the estimates give; masses and springs that the "
                                "rig file states are taken as exact."
                              : ""));
  HtmlTable table;
  table.heading = {"mode", "frequency, Hz", "damping ratio, %", "shape, DOF 1 …"};
  table.numeric = {true, true, true, false};
  for (size_t m = 0; m < modes.size(); ++m)
    table.rows.push_back({std::to_string(m + 1), interval_html(modes[m].frequency_Hz),
                          interval_html(percent(modes[m].damping_ratio)), shape_html(modes[m].shape)});
  page.html(table_html(table));
}

Curve curve(const std::vector<double>& x, const std::vector<double>& y, const char* label, Role role, Shape shape) {
  Curve out;
  out.x = x;
  out.y = y;
  out.label = label;
  out.role = role;
  out.shape = shape;
  return out;
}

// Up to where the drive moves the rig: the last bin whose neighbourhood has a mean coherence of a half, and an eighth
// more. Beyond, a response is noise. All of it where no band is driven.
size_t bins_shown(const ResponseView& view) {
  constexpr size_t kNeighbours = 16;
  const size_t count = view.coherence.size();
  double sum = 0.0;
  size_t last = 0;
  for (size_t k = 0; k < count; ++k) {
    sum += view.coherence[k] - (k >= kNeighbours ? view.coherence[k - kNeighbours] : 0.0);
    if (sum >= 0.5 * static_cast<double>(std::min(k + 1, kNeighbours))) last = k + 1;
  }
  return last == 0 ? count : std::min(count, last + last / 8 + 2);
}

std::vector<Plot> response_pictures(const ResponseView& view, Role simulated) {
  const auto first = [n = static_cast<std::ptrdiff_t>(bins_shown(view))](const std::vector<double>& values) {
    return values.empty() ? values : std::vector<double>(values.begin(), values.begin() + n);
  };
  const std::vector<double> frequency_Hz = first(view.frequency_Hz);
  Plot magnitude, coherence;
  magnitude.title = view.title;
  magnitude.x_label = coherence.x_label = "frequency";
  magnitude.x_unit = coherence.x_unit = "Hz";
  magnitude.y_label = view.label;
  magnitude.y_unit = view.unit;
  magnitude.log_y = true;
  magnitude.curves = {curve(frequency_Hz, first(view.measured), "measured", Role::kMeasured, Shape::kLine)};
  if (!view.simulated.empty())
    magnitude.curves.push_back(curve(frequency_Hz, first(view.simulated), "simulated", simulated, Shape::kDashed));
  coherence.title = "Coherence of the measurement";
  coherence.y_label = "coherence";
  coherence.note = "Average of " + std::to_string(view.segments) + " segments. Near 1: the motion follows the force.";
  coherence.curves = {curve(frequency_Hz, first(view.coherence), "", Role::kMeasured, Shape::kLine)};
  return {magnitude, coherence};
}

void add_responses(Page& page, const std::vector<ResponseView>& responses, Role simulated) {
  if (responses.empty()) return;
  page.section("responses", "Frequency response and coherence",
               "Motion per force, measured and simulated by the same averages. Where the coherence is low, noise, "
               "another force or a nonlinear link moves the rig.");
  for (const ResponseView& view : responses) page.figures(response_pictures(view, simulated));
}

Plot map_picture(const ForceStateMap& map, const std::vector<double>& values, double largest, const char* what) {
  Plot plot;
  plot.title = "Link " + map.link + ": " + what;
  plot.x_label = "elongation";
  plot.x_unit = map.elongation_unit;
  plot.y_label = "rate";
  plot.y_unit = map.rate_unit;
  plot.map = {map.columns, map.rows, map.elongation_low, map.elongation_high, map.rate_low, map.rate_high,
              values,      largest};
  const Prefix prefix = best_prefix(largest, map.force_unit);
  plot.note = "Purple pushes back, teal pulls; full depth is " + number_text(largest * prefix.factor, 3) + " " +
              prefix.symbol + unit_text(map.force_unit) + ".";
  return plot;
}

// Behind what a section says: of which record it is, where there are several.
std::string told_of(const RigViews& views) { return views.one_record.empty() ? "" : " Of " + views.one_record + "."; }

void add_maps(Page& page, const RigViews& views) {
  if (views.maps.empty()) return;
  page.section(
      "maps", "Force-state maps",
      "Restoring force of each link over its elongation and rate, the mean of the samples in each cell. A "
      "linear spring and damper make straight, even stripes; friction makes a step across rate zero, a gap or a "
      "stop bends the stripes at an elongation." +
          told_of(views));
  for (const ForceStateMap& map : views.maps) {
    double largest = 0.0;
    for (double value : map.measured)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    page.figures({map_picture(map, map.measured, largest, "measured force"),
                  map_picture(map, map.model, largest, "force of the model")});
  }
}

void add_residuals(Page& page, const RigViews& views) {
  if (views.residuals.empty()) return;
  page.section(
      "residuals", "Force that no term explains, over frequency",
      "Beside it the force that drives the DOF (without a drive: the force that accelerates it)." + told_of(views));
  std::vector<Plot> plots;
  for (const ResidualSpectrum& residual : views.residuals) {
    Plot plot;
    plot.title = "DOF " + std::to_string(residual.dof);
    plot.x_label = "frequency";
    plot.x_unit = "Hz";
    plot.y_label = "power density";
    plot.y_unit = density_unit(residual.unit);
    plot.log_y = true;
    plot.curves = {
        curve(residual.frequency_Hz, residual.reference, "force of the drive", Role::kMeasured, Shape::kLine),
        curve(residual.frequency_Hz, residual.residual, "left unexplained", Role::kGiven, Shape::kLine)};
    plots.push_back(std::move(plot));
  }
  page.figures(plots);
}

}  // namespace

void add_rig_sections(Page& page, const RigViews& views) {
  add_modes(page, views.modes);
  add_responses(page, views.responses, views.of_extended_rig ? Role::kExtended : Role::kGiven);
  add_maps(page, views);
  add_residuals(page, views);
  if (views.notes.empty()) return;
  std::string list;
  for (const std::string& note : views.notes) list += "<li>" + escaped(note) + "</li>\n";
  page.html("<h3>Not shown</h3>\n<ul class=\"advice\">\n" + list + "</ul>\n");
}

}  // namespace host_sim::reports

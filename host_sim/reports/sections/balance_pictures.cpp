// Pictures of the balance of forces: energies, and the force that each link leaves unexplained.
#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/reduce.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/sections/diagnosis_pictures.hpp"

namespace host_sim::reports {
namespace {

Curve over_time(const std::vector<double>& time_s, const std::vector<double>& values, size_t columns) {
  const size_t count = std::min(time_s.size(), values.size());
  if (count < 2) return {};
  const double period_s = (time_s[count - 1] - time_s[0]) / static_cast<double>(count - 1);
  return envelope_line(values, {0, count}, time_s[0], period_s, columns);
}

void add_shape(Plot& plot, const std::vector<double>& x, const std::vector<double>& y, const char* label, Role role,
               bool with_band) {
  const Binned shape = binned(x, y, 60);
  if (shape.x.empty()) return;
  Curve band, line;
  band.x = line.x = shape.x;
  band.y = shape.low;
  band.y_high = shape.high;
  line.y = shape.median;
  if (with_band) plot.curves.push_back(styled(band, std::string(label) + ", 10 to 90 %", role, Shape::kBand));
  plot.curves.push_back(styled(line, std::string(label) + (with_band ? ", median" : ""), role, Shape::kLine));
}

Plot force_against(const LinkView& link, const std::vector<double>& x, const std::string& label,
                   const std::string& unit) {
  Plot plot;
  plot.title = "Link " + link.link + ": against " + label;
  plot.x_label = label;
  plot.x_unit = unit;
  plot.y_label = "residual force";
  plot.y_unit = link.force_unit;
  plot.zero_line = true;
  add_shape(plot, x, link.residual, "rig as given", Role::kGiven, true);
  if (!link.residual_extended.empty())
    add_shape(plot, x, link.residual_extended, "extended rig", Role::kExtended, true);
  if (!link.named_force.empty() && link.named_force.size() == x.size()) {
    const Binned shape = binned(x, link.named_force, 60);
    Curve line;
    line.x = shape.x;
    line.y = shape.median;
    plot.curves.push_back(
        styled(line, "the named effect (" + link.named_effect + ")", Role::kMeasured, Shape::kDashed));
  }
  return plot;
}

}  // namespace

std::vector<std::string> energy_terms(const std::vector<DofView>& views) {
  std::vector<std::string> names;
  for (const DofView& view : views)
    for (const NamedSeries& term : view.energy.terms)
      if (std::find(names.begin(), names.end(), term.label) == names.end()) names.push_back(term.label);
  return names;
}

std::vector<Plot> energy_pictures(const DofView& view, const std::vector<std::string>& all_terms, size_t columns) {
  const EnergyBalance& energy = view.energy;
  Plot terms, left;
  terms.title = "DOF " + std::to_string(view.dof) + ": energy by term";
  left.title = "DOF " + std::to_string(view.dof) + ": energy left unexplained";
  terms.x_label = left.x_label = "time";
  terms.x_unit = left.x_unit = "s";
  terms.y_label = left.y_label = "energy since start";
  terms.y_unit = left.y_unit = "J";
  terms.zero_line = left.zero_line = true;
  for (const NamedSeries& term : energy.terms) {
    const auto place = std::find(all_terms.begin(), all_terms.end(), term.label) - all_terms.begin();
    terms.curves.push_back(styled(over_time(energy.time_s, term.values, columns), term.label,
                                  static_cast<Role>(static_cast<int>(Role::kTerm1) + static_cast<int>(place % 8)),
                                  place < 8 ? Shape::kLine : Shape::kDashed));
  }
  left.curves.push_back(styled(over_time(energy.time_s, energy.residual, columns), "left by the rig as given",
                               Role::kGiven, Shape::kLine));
  if (!energy.residual_extended.empty())
    left.curves.push_back(styled(over_time(energy.time_s, energy.residual_extended, columns),
                                 "left by the extended rig", Role::kExtended, Shape::kLine));
  return {terms, left};
}

std::vector<Plot> link_pictures(const LinkView& link) {
  Plot time;
  time.title = "Link " + link.link + ": over time";
  time.x_label = "time";
  time.x_unit = "s";
  time.y_label = "residual force";
  time.y_unit = link.force_unit;
  time.zero_line = true;
  const auto add = [&](const std::vector<double>& values, Role role) {
    const size_t count = std::min(values.size(), link.time_s.size());
    if (count < 2) return;
    const double period_s = (link.time_s[count - 1] - link.time_s[0]) / static_cast<double>(count - 1);
    time.curves.push_back(
        styled(envelope_band(values, {0, count}, link.time_s[0], period_s, kBandColumns), "", role, Shape::kBand));
  };
  add(link.residual, Role::kGiven);
  add(link.residual_extended, Role::kExtended);
  return {force_against(link, link.elongation, "elongation", link.elongation_unit),
          force_against(link, link.rate, "rate", link.rate_unit), time};
}

}  // namespace host_sim::reports

#include "host_sim/reports/sections/diagnosis_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/reduce.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/views/spectrum.hpp"

namespace host_sim::reports {
namespace {

constexpr char kGiven[] = "simulated, rig as given", kExtended[] = "simulated, extended rig";

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out(std::min(a.size(), b.size()));
  for (size_t i = 0; i < out.size(); ++i) out[i] = a[i] - b[i];
  return out;
}

Plot detail(const DofView& view, const Waveform& waveform, size_t columns) {
  Plot plot;
  plot.title = "DOF " + std::to_string(view.dof) + " " + waveform.quantity + ": worst moment";
  plot.x_label = "time";
  plot.x_unit = "s";
  plot.y_label = waveform.quantity;
  plot.y_unit = waveform.unit;
  plot.note = waveform.note;
  const Span span = most_different(waveform.measured, waveform.simulated, kDetailCycles);
  const auto add = [&](const std::vector<double>& values, const char* label, Role role, Shape shape) {
    if (values.size() == waveform.measured.size() && !values.empty())
      plot.curves.push_back(
          styled(envelope_line(values, span, view.start_s, view.period_s, columns), label, role, shape));
  };
  add(waveform.measured, "measured", Role::kMeasured, Shape::kLine);
  add(waveform.simulated, kGiven, Role::kGiven, Shape::kLine);
  add(waveform.extended, kExtended, Role::kExtended, Shape::kDashed);
  return plot;
}

Plot errors(const DofView& view, const Waveform& waveform, size_t columns) {
  Plot plot;
  plot.title = "DOF " + std::to_string(view.dof) + " " + waveform.quantity + ": whole record";
  plot.x_label = "time";
  plot.x_unit = "s";
  plot.y_label = "measured and error";
  plot.y_unit = waveform.unit;
  plot.zero_line = true;
  const auto add = [&](const std::vector<double>& values, const char* label, Role role) {
    if (values.empty()) return;
    const Span whole{0, values.size()};
    Curve band = envelope_band(values, whole, view.start_s, view.period_s, kBandColumns * columns / kColumns);
    band.opacity = role == Role::kMeasured ? 0.16 : 0.6;
    plot.curves.push_back(styled(std::move(band), label, role, Shape::kBand));
  };
  add(waveform.measured, "measured, its range", Role::kMeasured);
  add(difference(waveform.simulated, waveform.measured), "error of the rig as given", Role::kGiven);
  add(difference(waveform.extended, waveform.measured), "error of the extended rig", Role::kExtended);
  return plot;
}

Plot spectra(const DofView& view, const Waveform& waveform, size_t columns) {
  Plot plot;
  plot.title = "DOF " + std::to_string(view.dof) + " " + waveform.quantity + ": spectrum";
  plot.x_label = "frequency";
  plot.x_unit = "Hz";
  plot.y_label = "power density";
  plot.y_unit = density_unit(waveform.unit);
  plot.log_y = true;
  double cut_Hz = 0.0;  // the band that holds nearly all of the measured power
  const auto add = [&](const std::vector<double>& values, const char* label, Role role, Shape shape) {
    Spectrum spectrum = power_spectrum(values, view.period_s);
    if (spectrum.density.empty()) return;
    if (cut_Hz == 0.0) {
      double total = 0.0, sum = 0.0;
      for (double density : spectrum.density) total += density;
      size_t k = 0;
      while (k + 1 < spectrum.density.size() && sum < 0.995 * total) sum += spectrum.density[k++];
      cut_Hz = std::min(2.0 * spectrum.frequency_Hz[k], spectrum.frequency_Hz.back());
    }
    while (!spectrum.frequency_Hz.empty() && spectrum.frequency_Hz.back() > cut_Hz) {
      spectrum.frequency_Hz.pop_back();
      spectrum.density.pop_back();
    }
    const Spectrum small = reduced(spectrum, columns);
    Curve curve;
    curve.x = small.frequency_Hz;
    curve.y = small.density;
    plot.curves.push_back(styled(curve, label, role, shape));
  };
  add(waveform.measured, "measured", Role::kMeasured, Shape::kLine);
  add(waveform.simulated, kGiven, Role::kGiven, Shape::kLine);
  add(waveform.extended, kExtended, Role::kExtended, Shape::kDashed);
  return plot;
}

}  // namespace

size_t picture_columns(size_t dofs) { return dofs <= 6 ? kColumns : 2 * kColumns / 5; }

std::vector<Plot> waveform_pictures(const DofView& view, const Waveform& waveform, size_t columns) {
  return {detail(view, waveform, columns), errors(view, waveform, columns), spectra(view, waveform, columns)};
}

}  // namespace host_sim::reports

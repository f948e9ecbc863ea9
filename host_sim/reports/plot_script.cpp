// Plot -> gnuplot's language. A role's colour travels through gnuplot as the marker colour 0x0000RR (RR: role + 1).
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/reports/numbers.hpp"
#include "host_sim/reports/plot.hpp"

namespace host_sim::reports {
namespace {

std::string text(const std::string& plain) {  // as a single-quoted string, without gnuplot's markup
  std::string out = "'";
  for (char c : plain) out += c == '\'' ? std::string("''") : std::string(1, c);
  return out + "'";
}

std::string marker(Role role) {
  char out[16];
  std::snprintf(out, sizeof out, "'#0000%02x'", static_cast<unsigned>(role) + 1u);
  return out;
}

std::string number(double value) {
  char out[32];
  std::snprintf(out, sizeof out, "%.10g", value);
  return std::isfinite(value) ? out : "NaN";
}

// Symmetric range with air, so that a curve never lies on the frame; [0, 1] where there is nothing to show.
struct Range {
  double low = 0.0, high = 0.0;
  bool any = false;
  void add(double value) {
    if (!std::isfinite(value)) return;
    low = any ? std::min(low, value) : value;
    high = any ? std::max(high, value) : value;
    any = true;
  }
};

Range y_range(const Plot& plot) {
  Range range;
  for (const Curve& curve : plot.curves) {
    for (double value : curve.y)
      if (!plot.log_y || value > 0.0) range.add(value);
    for (double value : curve.y_high)
      if (!plot.log_y || value > 0.0) range.add(value);
    if (plot.log_y && range.any) break;  // the first curve is what was measured: nobody asks for what lies far below it
  }
  return range;
}

Range x_range(const Plot& plot) {
  Range range;
  for (const Curve& curve : plot.curves)
    for (double value : curve.x) range.add(value);
  return range;
}

std::string axis(const char* which, const Range& range, double scale, bool log) {
  double low = range.low * scale, high = range.high * scale;
  std::string out = std::string("set ") + which + "range [";
  if (!range.any) return out + "0:1]\n";
  if (log) return out + number(std::max(low, high * 1e-9) / 4.0) + ":" + number(high * 4.0) + "]\n";
  if (*which == 'y') {
    const double least = 2e-5 * std::max(std::abs(low), std::abs(high));  // ticks have six digits
    const double air = high > low ? std::max(0.06 * (high - low), least) : std::max(0.1 * std::abs(high), 1e-12);
    low -= air;
    high += air;
  } else if (!(high > low)) {
    low -= 0.5;
    high += 0.5;
  }
  return out + number(low) + ":" + number(high) + "]\n";
}

std::string data_block(const Curve& curve, double x_scale, double y_scale, const std::string& name) {
  std::string out = name + " << EOD\n";
  for (size_t i = 0; i < curve.x.size(); ++i) {
    if (!std::isfinite(curve.y[i])) {  // a gap
      out += "\n";
      continue;
    }
    const std::string point = number(curve.x[i] * x_scale) + " " + number(curve.y[i] * y_scale);
    out += point;
    if (curve.shape == Shape::kBand) out += " " + number(curve.y_high[i] * y_scale);
    out += "\n";
  }
  if (curve.x.empty()) out += "NaN NaN NaN\n";
  return out + "EOD\n";
}

std::string curve_command(const Curve& curve, const std::string& name, Target target) {
  const std::string title =
      target == Target::kStandalone && !curve.label.empty() ? " title " + text(curve.label) : " notitle";
  switch (curve.shape) {
    case Shape::kBand:
      return name + " using 1:2:3 with filledcurves fc rgb " + marker(curve.role) + " fs transparent solid " +
             number(curve.opacity) + " noborder" + title;
    case Shape::kDashed:
      return name + " using 1:2 with lines lw 1.6 dt (5,3) lc rgb " + marker(curve.role) + title;
    default:
      return name + " using 1:2 with lines lw 1.5 lc rgb " + marker(curve.role) + title;
  }
}

std::string label_with_unit(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " (" + unit_text(unit) + ")";
}

std::string one_plot(const Plot& plot, Target target, size_t index) {
  const Range x = x_range(plot), y = y_range(plot);
  const Prefix x_prefix =
      plot.scale_units ? best_prefix(std::max(std::abs(x.low), std::abs(x.high)), plot.x_unit) : Prefix{};
  const Prefix y_prefix = plot.scale_units && !plot.log_y
                              ? best_prefix(std::max(std::abs(y.low), std::abs(y.high)), plot.y_unit)
                              : Prefix{};
  std::string out;
  if (target == Target::kStandalone) out += "set title " + text(plot.title) + " noenhanced\n";
  out +=
      "set xlabel " + text(label_with_unit(plot.x_label, x_prefix.symbol + plot.x_unit)) + " noenhanced offset 0,0.3\n";
  out += "set ylabel " + text(label_with_unit(plot.y_label, y_prefix.symbol + plot.y_unit)) + " noenhanced offset " +
         (plot.log_y ? "1.6" : "0.6") + ",0\n";
  out += plot.log_y ? "set logscale y 10\nset format y '10^{%L}'\n" : "unset logscale y\nset format y '%g'\n";
  out += axis("x", x, x_prefix.factor, false) + axis("y", y, y_prefix.factor, plot.log_y);
  out += plot.zero_line ? "set xzeroaxis lw 1 dt solid lc rgb '#000070'\n" : "unset xzeroaxis\n";
  std::string commands;
  for (size_t i = 0; i < plot.curves.size(); ++i) {
    const std::string name = "$D" + std::to_string(index) + "_" + std::to_string(i);
    out += data_block(plot.curves[i], x_prefix.factor, y_prefix.factor, name);
    commands += (i ? ", " : "plot ") + curve_command(plot.curves[i], name, target);
  }
  return out + (commands.empty() ? "plot NaN notitle" : commands) + "\n";
}

}  // namespace

std::string plot_script(const std::vector<Plot>& plots, Target target) {
  const bool alone = target == Target::kStandalone;
  const int width = alone ? 640 : kPlotWidth, height = alone ? 380 : kPlotHeight;
  std::string out = "set terminal svg size " + std::to_string(width) + "," + std::to_string(height) +
                    " dynamic rounded enhanced font 'sans-serif,12' background '#000073'\n";
  out += "set encoding utf8\nset border 3 lw 1 lc rgb '#000071'\nset tics nomirror out scale 0.5 tc rgb '#000072'\n";
  out += "set grid lw 1 lt 1 dt solid lc rgb '#000070'\nset xlabel tc rgb '#000072'\nset ylabel tc rgb '#000072'\n";
  out += "set xtics autofreq\nset datafile missing NaN\n";
  out +=
      alone
          ? "set bmargin 5.5\nset key below center horizontal noenhanced\n"
          : "set lmargin at screen 0.15\nset rmargin at screen 0.97\nset tmargin at screen 0.91\nset bmargin at screen "
            "0.23\nunset key\n";
  for (size_t i = 0; i < plots.size(); ++i) out += one_plot(plots[i], target, i);
  return out;
}

std::vector<std::string> draw(const std::vector<Plot>& plots, Target target) {
  return plots.empty() ? std::vector<std::string>() : finish_svg(run_gnuplot(plot_script(plots, target)), target);
}

}  // namespace host_sim::reports

// A picture as data: what to draw, with labels and units, and nothing about where.
#pragma once
#include <string>
#include <vector>

#include "host_sim/reports/drawing_error.hpp"

namespace host_sim::reports {

// What a curve means decides its colour on every page, in light and in dark.
enum class Role {
  kMeasured,
  kGiven,
  kExtended,
  kTruth,
  kTerm1,
  kTerm2,
  kTerm3,
  kTerm4,
  kTerm5,
  kTerm6,
  kTerm7,
  kTerm8,
};
constexpr int kRoles = 12;

enum class Shape { kLine, kDashed, kBand };

struct Curve {
  std::string label;  // in the legend; empty: not listed
  Role role = Role::kMeasured;
  Shape shape = Shape::kLine;
  std::vector<double> x, y;
  std::vector<double> y_high;  // of a band: y is its lower edge
  double opacity = 0.28;       // of a band
};

struct Plot {
  std::string title;            // "DOF 1, displacement"
  std::string note;             // a sentence below the picture
  std::string x_label, x_unit;  // "time", "s"
  std::string y_label, y_unit;
  bool log_y = false;
  bool scale_units = true;  // let "m" become "mm" where the numbers ask for it
  bool zero_line = false;
  std::vector<Curve> curves;
};

constexpr int kPlotWidth = 460, kPlotHeight = 270;  // units of the picture's own coordinates

// Colour of a role as a style-sheet variable of the page, "var(--measured)", or as "#rrggbb" in the light palette.
const char* role_variable(Role role);
const char* role_colour(Role role);

enum class Target {
  kPage,        // inside a page that defines the colours and draws the legend itself
  kStandalone,  // a picture file: own colours, background, legend and title
};

// One SVG element per plot, in order, from one run of gnuplot. Throws DrawingError as run_gnuplot does.
std::vector<std::string> draw(const std::vector<Plot>& plots, Target target);

// The script that draws the plots, one SVG document each on stdout.
std::string plot_script(const std::vector<Plot>& plots, Target target);

// Output of gnuplot for a script. Throws DrawingError: gnuplot is missing (names the package), or its own
// message.
std::string run_gnuplot(const std::string& script);

// Splits gnuplot's output into documents and makes each fit for its target: no prologue, no unused definitions,
// no ids, role colours as variables (kPage) or as numbers (kStandalone).
std::vector<std::string> finish_svg(const std::string& gnuplot_output, Target target);

}  // namespace host_sim::reports

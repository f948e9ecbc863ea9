// A picture as data: what to draw, with labels and units, and nothing about where.
#pragma once
#include <cmath>
#include <string>
#include <vector>

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

enum class Shape { kLine, kDashed, kBand, kPoints };

struct Curve {
  std::string label;  // in the legend; empty: not listed
  Role role = Role::kMeasured;
  Shape shape = Shape::kLine;
  std::vector<double> x, y;
  std::vector<double> y_high;  // of a band: y is its lower edge
  double opacity = 0.28;       // of a band
};

// The curve as it is to be drawn.
inline Curve styled(Curve curve, const std::string& label, Role role, Shape shape) {
  curve.label = label, curve.role = role, curve.shape = shape;
  return curve;
}

// A map: a value for each cell of a rectangle, drawn as the depth of one of two colours by its sign.
struct ColourMap {
  size_t columns = 0, rows = 0;  // rows from below
  double x_low = 0.0, x_high = 1.0, y_low = 0.0, y_high = 1.0;
  std::vector<double> values;  // row by row; not a number: nothing known there
  double largest = 0.0;        // the value of full depth; 0: the largest of all
};

struct Plot {
  std::string title;            // "DOF 1, displacement"
  std::string note;             // a sentence below the picture
  std::string x_label, x_unit;  // "time", "s"
  std::string y_label, y_unit;
  bool log_y = false;
  bool scale_units = true;  // let "m" become "mm" where the numbers ask for it
  bool zero_line = false;
  // The vertical range of the frame, where curves are to be cut off; not numbers: what the curves take.
  double y_low = NAN, y_high = NAN;
  std::vector<Curve> curves;
  ColourMap map;  // below the curves; no columns: none
};

constexpr int kPlotWidth = 460, kPlotHeight = 270;  // units of the picture's own coordinates

// Colour of a role as a style-sheet variable of the page, "var(--measured)".
const char* role_variable(Role role);

enum class Target {
  kPage,        // inside a page that defines the colours and draws the legend itself
  kStandalone,  // a picture file: own colours, background, legend and title
};

// One SVG element; the same bytes for the same plot on every machine.
std::string draw(const Plot& plot, Target target);

}  // namespace host_sim::reports

// Plot -> SVG: frame, grid, ticks, labels, curves; colours are the page's variables or, in a picture file, numbers.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "host_sim/reports/figures/axis.hpp"
#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/figures/path.hpp"
#include "host_sim/reports/figures/plot.hpp"
#include "host_sim/reports/figures/range.hpp"

namespace host_sim::reports {
namespace {

struct Palette {
  const char* variable;
  const char* light;
};

constexpr Palette kRolePalette[kRoles] = {
    {"var(--measured)", "#24292f"}, {"var(--given)", "#cf5a0c"}, {"var(--extended)", "#1466c4"},
    {"var(--truth)", "#2c7a3f"},    {"var(--term1)", "#0b7f8a"}, {"var(--term2)", "#7d4fa6"},
    {"var(--term3)", "#a87b00"},    {"var(--term4)", "#b93a72"}, {"var(--term5)", "#75563b"},
    {"var(--term6)", "#5f7d1a"},    {"var(--term7)", "#53687c"}, {"var(--term8)", "#a3485a"},
};
constexpr Palette kGrid = {"var(--grid)", "#e4e7eb"}, kFrame = {"var(--frame)", "#9aa3ad"},
                  kText = {"var(--soft)", "#57606a"};

std::string number(double value) {
  char out[32];
  std::snprintf(out, sizeof out, "%.1f", value);
  std::string text = out;
  if (text.size() > 2 && text.compare(text.size() - 2, 2, ".0") == 0) text.resize(text.size() - 2);
  return text == "-0" ? "0" : text;
}

// Of a label in the largest lettering that a page sets it in (14.5 units, where the screen is narrow).
double label_width(const std::string& svg_text) {
  double width = 0.0;
  bool tag = false;
  for (char c : svg_text) {
    if (c == '<') tag = true;
    if (!tag && (static_cast<unsigned char>(c) & 0xC0) != 0x80) width += c == '.' ? 4.7 : 9.3;
    if (c == '>') tag = false;
  }
  return width;
}

std::string escaped_text(const std::string& plain) {
  std::string out;
  for (char c : plain) out += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return out;
}

class Drawing {
 public:
  Drawing(const Plot& plot, Target target)
      : plot_(plot), alone_(target == Target::kStandalone), width_(alone_ ? 640 : kPlotWidth) {
    const int legend_rows = alone_ ? static_cast<int>(listed_curves() + 1) / 2 : 0;
    plot_height_ = alone_ ? 340 : kPlotHeight;
    height_ = plot_height_ + 20 * legend_rows;
    top_ = alone_ ? 34 : 14, bottom_ = plot_height_ - 46.0;
    scale_axes();
    place_axes();
  }

  std::string svg() const {
    std::string out = "<svg viewBox=\"0 0 " + std::to_string(width_) + " " + std::to_string(height_) + "\"";
    if (alone_) out += " xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" font-size=\"12\"";
    out += ">\n";
    if (alone_)
      out += "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n" +
             text(0.5 * width_, 20, "middle", escaped_text(plot_.title));
    out += map() + grid() + curves() + frame() + labels();
    if (alone_) out += legend();
    return out + "</svg>";
  }

 private:
  std::string colour(const Palette& palette) const { return alone_ ? palette.light : palette.variable; }
  std::string colour(Role role) const { return colour(kRolePalette[static_cast<int>(role)]); }
  size_t listed_curves() const {
    return static_cast<size_t>(std::count_if(plot_.curves.begin(), plot_.curves.end(),
                                             [](const Curve& curve) { return !curve.label.empty(); }));
  }

  void scale_axes() {
    const Range x = x_range(plot_), y = y_range(plot_);
    if (plot_.scale_units) x_prefix_ = best_prefix(x.size(), plot_.x_unit);
    if (plot_.scale_units && !plot_.log_y) y_prefix_ = best_prefix(y.size(), plot_.y_unit);
    double low = x.low * x_prefix_.factor, high = x.high * x_prefix_.factor;
    if (!x.any || !(high > low)) low -= 0.5, high += 0.5;
    x_ = linear_axis(low, high, 6);
    low = y.low * y_prefix_.factor, high = y.high * y_prefix_.factor;
    if (plot_.log_y) {
      y_ = y.any ? decade_axis(std::max(low, high * 1e-9) / 4.0, high * 4.0, 6) : decade_axis(0.1, 10.0, 6);
    } else if (!y.any) {
      y_ = linear_axis(0.0, 1.0, 5);
    } else {
      const double least = 2e-5 * std::max(std::abs(low), std::abs(high));  // ticks have six digits
      const double share = plot_.map.columns > 0 ? 0.0 : 0.06;
      const double air = high > low ? std::max(share * (high - low), plot_.map.columns > 0 ? 0.0 : least)
                                    : std::max(0.1 * std::abs(high), 1e-12);
      y_ = linear_axis(low - air, high + air, 5);
    }
  }

  // The frame leaves room for the widest label at its left, beside the axis' name, and for half the last one at its right.
  void place_axes() {
    constexpr double kNameOfAxis = 24.0, kGap = 7.0, kAir = 12.0;
    double widest = 0.0;
    for (const Tick& tick : y_.ticks) widest = std::max(widest, label_width(tick.label));
    const double last = x_.ticks.empty() ? 0.0 : 0.5 * label_width(x_.ticks.back().label);
    left_ = std::max(66.0, kNameOfAxis + kGap + widest);
    right_ = width_ - std::max(kAir, last + 1.0);
    x_.at_low = left_, x_.at_high = right_;
    y_.at_low = bottom_, y_.at_high = top_;
  }

  Point place(double x, double y) const {
    if (!std::isfinite(y) || !std::isfinite(x)) return {NAN, NAN};
    // Far outside the frame, where nothing is seen, a picture needs no number of many digits.
    const double far = 100.0 * height_;
    return {x_.place(x * x_prefix_.factor), std::clamp(y_.place(y * y_prefix_.factor), -far, far)};
  }

  std::string text(double x, double y, const char* anchor, const std::string& content, const char* more = "") const {
    return "<text x=\"" + number(x) + "\" y=\"" + number(y) + "\" text-anchor=\"" + anchor + "\"" +
           (alone_ ? " fill=\"" + colour(kText) + "\"" : " class=\"t\"") + more + ">" + content + "</text>\n";
  }

  std::string grid() const {
    std::string path;
    for (const Tick& tick : x_.ticks)
      path += "M" + number(x_.place(tick.value)) + " " + number(top_) + "V" + number(bottom_);
    for (const Tick& tick : y_.ticks)
      path += "M" + number(left_) + " " + number(y_.place(tick.value)) + "H" + number(right_);
    std::string out = "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour(kGrid) + "\"/>\n";
    if (plot_.zero_line && y_.low < 0.0 && y_.high > 0.0)
      out += "<path d=\"M" + number(left_) + " " + number(y_.place(0.0)) + "H" + number(right_) + "\" stroke=\"" +
             colour(kFrame) + "\"/>\n";
    return out;
  }

  std::string frame() const {
    std::string path = "M" + number(left_) + " " + number(top_) + "V" + number(bottom_) + "H" + number(right_), out;
    for (const Tick& tick : x_.ticks) {
      path += "M" + number(x_.place(tick.value)) + " " + number(bottom_) + "v4";
      out += text(x_.place(tick.value), bottom_ + 17, "middle", tick.label);
    }
    for (const Tick& tick : y_.ticks) {
      path += "M" + number(left_) + " " + number(y_.place(tick.value)) + "h-4";
      out += text(left_ - 7, y_.place(tick.value) + 4, "end", tick.label);
    }
    return "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour(kFrame) + "\"/>\n" + out;
  }

  static std::string with_unit(const std::string& label, const std::string& unit) {
    return escaped_text(unit.empty() ? label : label + " (" + unit_text(unit) + ")");
  }

  std::string labels() const {
    const double middle = 0.5 * (top_ + bottom_);
    // Half of the lettering's height in width, on average; a name that finds no room is in the picture's title.
    const std::string name = with_unit(plot_.y_label, y_prefix_.symbol + plot_.y_unit);
    const bool fits = 7.6 * static_cast<double>(name.size()) < height_;
    const std::string turned = " transform=\"rotate(-90 14 " + number(middle) + ")\"";
    return text(0.5 * (left_ + right_), bottom_ + 37, "middle",
                with_unit(plot_.x_label, x_prefix_.symbol + plot_.x_unit)) +
           text(14, middle, "middle", fits ? name : escaped_text(unit_text(y_prefix_.symbol + plot_.y_unit)),
                turned.c_str());
  }

  std::string curve(const Curve& curve) const {
    std::vector<Point> points;
    for (size_t i = 0; i < curve.x.size(); ++i) points.push_back(place(curve.x[i], curve.y[i]));
    const std::string ink = colour(curve.role);
    if (curve.shape == Shape::kBand) {
      for (size_t i = curve.x.size(); i-- > 0;) points.push_back(place(curve.x[i], curve.y_high[i]));
      char opacity[24];
      std::snprintf(opacity, sizeof opacity, "%.2g", curve.opacity);
      return "<path d=\"" + path_data(points, true) + "\" fill=\"" + ink + "\" fill-opacity=\"" + opacity + "\"/>\n";
    }
    if (curve.shape == Shape::kPoints) {
      std::string out = "<g fill=\"" + ink + "\" fill-opacity=\".55\">";
      for (const Point& point : points)
        if (std::isfinite(point.x))
          out += "<circle cx=\"" + number(point.x) + "\" cy=\"" + number(point.y) + "\" r=\"1.6\"/>";
      return out + "</g>\n";
    }
    return "<path d=\"" + path_data(points) + "\" fill=\"none\" stroke=\"" + ink + "\" stroke-width=\"1.5\"" +
           " stroke-linejoin=\"round\"" + (curve.shape == Shape::kDashed ? " stroke-dasharray=\"5 3\"" : "") + "/>\n";
  }

  // Curves may leave the frame (a logarithmic plot shows the measured range): they are cut off there.
  std::string curves() const {
    std::string out = "<svg x=\"" + number(left_) + "\" y=\"" + number(top_) + "\" width=\"" + number(right_ - left_) +
                      "\" height=\"" + number(bottom_ - top_) + "\" viewBox=\"" + number(left_) + " " + number(top_) +
                      " " + number(right_ - left_) + " " + number(bottom_ - top_) + "\">\n";
    for (const Curve& each : plot_.curves)
      if (!each.x.empty()) out += curve(each);
    return out + "</svg>\n";
  }

  std::string map() const {
    const ColourMap& map = plot_.map;
    if (map.columns == 0) return "";
    double largest = map.largest;
    if (!(largest > 0.0))
      for (double value : map.values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    std::string out = "<g shape-rendering=\"crispEdges\">\n";
    const double width = (right_ - left_) / static_cast<double>(map.columns);
    const double height = (bottom_ - top_) / static_cast<double>(map.rows);
    for (size_t r = 0; r < map.rows; ++r)
      for (size_t c = 0; c < map.columns; ++c) {
        const double value = map.values[r * map.columns + c];
        if (!std::isfinite(value) || !(largest > 0.0)) continue;
        char depth[24];
        std::snprintf(depth, sizeof depth, "%.2f", std::min(1.0, 0.04 + 0.96 * std::abs(value) / largest));
        out += "<path d=\"M" + number(left_ + width * static_cast<double>(c)) + " " +
               number(bottom_ - height * static_cast<double>(r)) + "h" + number(width + 0.05) + "v-" +
               number(height + 0.05) + "h-" + number(width + 0.05) + "z\" fill=\"" +
               colour(value >= 0.0 ? Role::kTerm2 : Role::kTerm1) + "\" fill-opacity=\"" + depth + "\"/>\n";
      }
    return out + "</g>\n";
  }

  std::string legend() const {
    std::string out;
    int n = 0;
    for (const Curve& curve : plot_.curves) {
      if (curve.label.empty()) continue;
      const double x = left_ + (n % 2) * 0.5 * (right_ - left_), y = plot_height_ + 8.0 + 20.0 * (n / 2);
      const bool band = curve.shape == Shape::kBand;
      out += "<path d=\"M" + number(x) + " " + number(y) + "h24\" stroke=\"" + colour(curve.role) +
             "\" stroke-width=\"" + (band ? "9\" stroke-opacity=\".3" : "2.5") + "\"" +
             (curve.shape == Shape::kDashed ? " stroke-dasharray=\"5 3\"" : "") + "/>\n" +
             text(x + 32, y + 4, "start", escaped_text(curve.label));
      ++n;
    }
    return out;
  }

  const Plot& plot_;
  const bool alone_;
  int width_, plot_height_ = 0, height_ = 0;
  double left_ = 0.0, right_ = 0.0, top_ = 0.0, bottom_ = 0.0;
  Prefix x_prefix_, y_prefix_;
  Axis x_, y_;
};

}  // namespace

const char* role_variable(Role role) { return kRolePalette[static_cast<int>(role)].variable; }

std::string draw(const Plot& plot, Target target) { return Drawing(plot, target).svg(); }

}  // namespace host_sim::reports

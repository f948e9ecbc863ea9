#include "host_sim/reports/figures/figure_csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace host_sim::reports {
namespace {

bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

// Letters, digits and single underscores.
std::string plain_name(const std::string& text) {
  std::string name;
  for (char c : text) {
    if (is_letter_or_digit(c))
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string column_name(const std::string& label, const std::string& unit, const char* otherwise) {
  const std::string name = label.empty() ? otherwise : lower(plain_name(label));
  // "m/s^2" is m_s2 in every name of a column
  std::string in_names = unit;
  in_names.erase(std::remove(in_names.begin(), in_names.end(), '^'), in_names.end());
  return unit.empty() ? name : name + "_" + plain_name(in_names);
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

std::string map_csv(const Plot& plot, const std::string& x, const std::string& y) {
  const ColourMap& map = plot.map;
  std::string out = x + "," + y + ",value\n";
  const double width = (map.x_high - map.x_low) / static_cast<double>(map.columns);
  const double height = (map.y_high - map.y_low) / static_cast<double>(map.rows);
  for (size_t row = 0; row < map.rows; ++row)
    for (size_t column = 0; column < map.columns; ++column) {
      const double value = map.values[row * map.columns + column];
      if (!std::isfinite(value)) continue;
      out += fmt::format("{:.9g},{:.9g},{:.9g}\n", map.x_low + (static_cast<double>(column) + 0.5) * width,
                         map.y_low + (static_cast<double>(row) + 0.5) * height, value);
    }
  return out;
}

}  // namespace

std::string figure_csv(const Plot& plot) {
  const std::string x = column_name(plot.x_label, plot.x_unit, "x"), y = column_name(plot.y_label, plot.y_unit, "y");
  if (plot.map.columns > 0) return map_csv(plot, x, y);
  const bool band =
      std::any_of(plot.curves.begin(), plot.curves.end(), [](const Curve& curve) { return !curve.y_high.empty(); });
  std::string out = "curve," + x + "," + y + (band ? ",upper\n" : "\n");
  for (size_t c = 0; c < plot.curves.size(); ++c) {
    const Curve& curve = plot.curves[c];
    const std::string name = curve.label.empty() ? "curve_" + std::to_string(c + 1) : quoted(curve.label);
    for (size_t i = 0; i < curve.x.size() && i < curve.y.size(); ++i) {
      if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i])) continue;
      out += fmt::format("{},{:.9g},{:.9g}", name, curve.x[i], curve.y[i]);
      if (band) out += i < curve.y_high.size() ? fmt::format(",{:.9g}", curve.y_high[i]) : ",";
      out += '\n';
    }
  }
  return out;
}

std::string figure_file_name(size_t number, const Plot& plot) {
  const std::string name = lower(plain_name(plot.title));
  return fmt::format("{:02}_{}.csv", number, name.empty() ? "figure" : name);
}

bool is_figure_file_name(const std::string& name) {
  size_t digits = 0;
  while (digits < name.size() && std::isdigit(static_cast<unsigned char>(name[digits]))) ++digits;
  if (digits < 2 || digits == name.size() || name[digits] != '_') return false;
  const size_t end = name.size() - std::min<size_t>(name.size(), 4);
  return name.substr(end) == ".csv" && std::all_of(name.begin() + static_cast<std::ptrdiff_t>(digits),
                                                   name.begin() + static_cast<std::ptrdiff_t>(end),
                                                   [](char c) { return is_letter_or_digit(c) || c == '_'; });
}

}  // namespace host_sim::reports

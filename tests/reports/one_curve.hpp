// A picture of one curve, and how often a text holds another.
#pragma once
#include <string>

#include "host_sim/reports/figures/plot.hpp"

namespace one_curve {

using namespace host_sim::reports;

inline size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// Through (0 s, 1 mm), (1 s, 2 mm), (2 s, 1.5 mm).
inline Plot plot(const std::string& y_label) {
  Plot out;
  out.title = "a <'title'>";
  out.x_label = "time";
  out.x_unit = "s";
  out.y_label = y_label;
  out.y_unit = "m";
  out.curves = {{"one", Role::kGiven, Shape::kLine, {0, 1, 2}, {0.001, 0.002, 0.0015}, {}}};
  return out;
}

}  // namespace one_curve

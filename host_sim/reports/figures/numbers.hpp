// Numbers and units as a reader wants them.
#pragma once
#include <string>

namespace host_sim::reports {

struct Prefix {
  std::string symbol;   // "m", "k", "" ...
  double factor = 1.0;  // value in the unit * factor = value in the prefixed unit
};

// The SI prefix that brings `largest` into 1 .. 1000. None for a unit that takes none: empty, "s", "Hz", "%", powers
// and products whose first unit is raised ("m^2"), and units that carry a prefix already ("kg").
Prefix best_prefix(double largest, const std::string& unit);

// "N/m^3" -> "N/m³", "N s/m" -> "N·s/m".
std::string unit_text(const std::string& unit);

// `digits` significant digits, HTML: "20.05", "3.12 × 10<sup>7</sup>", an en dash where not finite.
std::string number_html(double value, int digits = 4);

// Plain text: "20.05", "3.12e+07".
std::string number_text(double value, int digits = 4);

// A share in percent to two digits, from a hundred on whole: "4.1", "68", "412".
std::string percent_text(double percent);

// An error in percent to three digits; from 1000 on, where no more is said, ">1000".
std::string missed_text(double percent);
std::string missed_html(double percent);

}  // namespace host_sim::reports

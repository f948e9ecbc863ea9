#include "host_sim/reports/figures/numbers.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace host_sim::reports {

Prefix best_prefix(double largest, const std::string& unit) {
  const std::string first = unit.substr(0, unit.find_first_of(" /*"));
  const bool takes_one = first == "m" || first == "N" || first == "J" || first == "W" || first == "V" || first == "rad";
  if (!takes_one || !std::isfinite(largest) || largest <= 0.0) return {};
  static const struct {
    const char* symbol;
    double factor;
  } kPrefixes[] = {{"G", 1e-9}, {"M", 1e-6}, {"k", 1e-3}, {"", 1.0}, {"m", 1e3}, {"µ", 1e6}, {"n", 1e9}};
  for (const auto& prefix : kPrefixes)
    if (largest * prefix.factor >= 0.9999) return {prefix.symbol, prefix.factor};
  return {"n", 1e9};
}

std::string unit_text(const std::string& unit) {
  static const char* const kRaised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out;
  for (size_t i = 0; i < unit.size(); ++i) {
    if (unit[i] == '^' && i + 1 < unit.size() && unit[i + 1] >= '0' && unit[i + 1] <= '9') {
      out += kRaised[unit[++i] - '0'];
    } else if (unit[i] == ' ') {
      out += "·";
    } else {
      out += unit[i];
    }
  }
  return out;
}

std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  char out[40];
  std::snprintf(out, sizeof out, "%#.*g", digits, value);  // '#': keep the zeros that carry precision
  std::string text = out;
  const size_t exponent = text.find('e');
  std::string mantissa = text.substr(0, exponent);
  if (mantissa.back() == '.') mantissa.pop_back();
  return exponent == std::string::npos ? mantissa : mantissa + text.substr(exponent);
}

std::string number_html(double value, int digits) {
  if (value == 0.0) return "0";
  const std::string plain = number_text(value, digits);
  const size_t exponent = plain.find('e');
  const std::string mantissa = plain.substr(0, exponent);
  std::string out = mantissa[0] == '-' ? "−" + mantissa.substr(1) : mantissa;
  if (exponent == std::string::npos) return out;
  const int power = std::atoi(plain.c_str() + exponent + 1);
  return out + " × 10<sup>" + (power < 0 ? "−" : "") + std::to_string(std::abs(power)) + "</sup>";
}

std::string percent_text(double percent) {
  if (!(percent >= 99.5) || std::isinf(percent)) return number_text(percent, 2);
  char out[40];
  std::snprintf(out, sizeof out, "%.0f", percent);
  return out;
}

std::string missed_text(double percent) { return percent >= 1000.0 ? ">1000" : number_text(percent, 3); }

std::string missed_html(double percent) { return percent >= 1000.0 ? "&gt;1000" : number_html(percent, 3); }

}  // namespace host_sim::reports

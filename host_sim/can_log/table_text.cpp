#include "host_sim/can_log/table_text.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace can_log {

double factor(const firmware::can::Signal& signal) {
  return static_cast<double>(signal.factor_numerator) / signal.factor_denominator;
}

double physical(const firmware::can::Signal& signal, int64_t raw) {
  return static_cast<double>(raw) * signal.factor_numerator / signal.factor_denominator + signal.offset;
}

std::string shortest(double value) {
  std::string text;
  for (int digits = 1; digits <= 17; ++digits) {
    text = fmt::format("{:.{}g}", value, digits);
    if (std::strtod(text.c_str(), nullptr) == value) break;
  }
  // Plain digits where they are few: 4294967295, not 4.294967295e+09.
  if (value < 1e15 && value > -1e15 && value == static_cast<double>(static_cast<int64_t>(value)))
    return std::to_string(static_cast<int64_t>(value));
  return text;
}

std::string lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace can_log

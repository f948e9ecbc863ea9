#include "host_sim/reports/page/shared_parts.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/reports/figures/numbers.hpp"

namespace host_sim::reports {

std::string facts_html(const std::vector<std::string>& facts) {
  std::string out = "<ul class=\"facts\">";
  for (const std::string& fact : facts) out += "<li>" + escaped(fact) + "</li>";
  return out + "</ul>\n";
}

int digits_for(const Interval& interval) {
  const double width = interval.high - interval.low;
  if (!(width > 0.0) || !std::isfinite(width) || interval.value == 0.0) return 5;
  return std::clamp(static_cast<int>(std::ceil(std::log10(std::abs(interval.value) / width))) + 2, 3, 7);
}

std::string interval_html(const Interval& interval) {
  if (!std::isfinite(interval.value)) return "<span class=\"dim\">–</span>";
  const int digits = digits_for(interval);
  std::string out = number_html(interval.value, digits);
  if (std::isfinite(interval.low) && std::isfinite(interval.high))
    out += " <span class=\"dim\">(" + number_html(interval.low, digits) + " … " + number_html(interval.high, digits) +
           ")</span>";
  return out;
}

std::string how_simulated(bool free) {
  return free ? "simulated freely under the measured force"
              : "not simulated: the measured force beside the one that it needs for the measured motion";
}

std::string density_unit(const std::string& unit) {
  return (unit.find_first_of("/ ^") == std::string::npos ? unit : "(" + unit + ")") + "^2/Hz";
}

std::string status_html(const std::string& status) {
  if (status.empty()) return "";
  return std::string("<span class=\"") + (status == "VALID" ? "good" : "warn") + "\">" + escaped(status) + "</span>";
}

}  // namespace host_sim::reports

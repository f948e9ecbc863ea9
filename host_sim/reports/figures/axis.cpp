#include "host_sim/reports/figures/axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace host_sim::reports {
namespace {

std::string signed_text(std::string plain) { return plain[0] == '-' ? "−" + plain.substr(1) : plain; }

std::string power_of_ten(int power) {
  return "10<tspan class=\"e\" dy=\"-5\" font-size=\"9\">" + signed_text(std::to_string(power)) + "</tspan>";
}

// A multiple of `step`: as many decimals as the step has.
std::string label(double value, double step, double largest) {
  char text[48];
  const int step_power = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  const int largest_power = largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest) + 1e-9)) : 0;
  if (value == 0.0) return "0";
  if (largest_power > 4 || step_power < -5) {
    std::snprintf(text, sizeof text, "%.*f", std::max(0, largest_power - step_power),
                  value / std::pow(10.0, largest_power));
    return signed_text(text) + "·" + power_of_ten(largest_power);
  }
  std::snprintf(text, sizeof text, "%.*f", std::max(0, -step_power), value);
  return signed_text(text);
}

size_t ticks_within(double low, double high, double step) {
  return static_cast<size_t>(std::max(0.0, std::floor(high / step + 1e-9) - std::ceil(low / step - 1e-9) + 1.0));
}

// The largest of 10, 5, 2, 1 .. times a power of ten that gives at most `wanted` ticks and, so that a range can be read
// at all, at least three.
double round_step(double low, double high, int wanted) {
  const double rough = (high - low) / wanted, power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (double factor : {5.0, 2.0, 1.0, 0.5})
    if (factor * power >= rough * (1.0 - 1e-9) || ticks_within(low, high, step) < 3) step = factor * power;
  return step;
}

}  // namespace

double Axis::place(double value) const {
  const double share =
      log ? std::log(std::max(value, low * 1e-3) / low) / std::log(high / low) : (value - low) / (high - low);
  return at_low + std::clamp(share, -0.5, 1.5) * (at_high - at_low);
}

Axis linear_axis(double low, double high, int wanted) {
  Axis axis;
  axis.low = low;
  axis.high = high;
  const double step = round_step(low, high, wanted), largest = std::max(std::abs(low), std::abs(high));
  for (double n = std::ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; n += 1.0)
    axis.ticks.push_back({n * step, label(n * step, step, largest)});
  return axis;
}

Axis decade_axis(double low, double high, int wanted) {
  Axis axis;
  axis.low = low;
  axis.high = high;
  axis.log = true;
  const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
  const int step = std::max(1, (last - first + wanted) / wanted);
  for (int power = first; power <= last; power += step)
    axis.ticks.push_back({std::pow(10.0, power), power_of_ten(power)});
  return axis;
}

}  // namespace host_sim::reports

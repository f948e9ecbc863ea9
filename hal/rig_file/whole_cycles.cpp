#include "hal/rig_file/whole_cycles.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace rig_file {

void set_whole_cycles(double cycle_samples, firmware::WindowConfiguration& window) {
  if (!can_be_whole(cycle_samples)) throw std::domain_error("a cycle of " + std::to_string(cycle_samples) + " samples");
  uint32_t denominator = 1u << 16;
  while (std::round(cycle_samples * denominator) > kMostCycleSamples) denominator /= 2;
  window.mode = firmware::WindowMode::kWholeCycles;
  window.cycle_samples_numerator = static_cast<uint32_t>(std::lround(cycle_samples * denominator));
  window.cycle_samples_denominator = denominator;
}

}  // namespace rig_file

// Windows of whole cycles of an excitation whose cycle is no whole number of samples.
#pragma once
#include "firmware/configuration/configuration.hpp"

namespace rig_file {

constexpr double kLeastCycleSamples = 4.0, kMostCycleSamples = (1u << 30) - 1.0;
constexpr bool can_be_whole(double cycle_samples) {
  return cycle_samples >= kLeastCycleSamples && cycle_samples <= kMostCycleSamples;
}

// Sets window.mode and the cycle's length as a fraction: the numerator below 2^30 (the core counts in a sixteenth of a cycle and twice
// its product with samples fits), the denominator a power of two up to 2^16. The length is right to 2^-17 samples up to 2^14
// samples, and to 2^-30 of itself beyond. A cycle that cannot be whole: std::domain_error.
void set_whole_cycles(double cycle_samples, firmware::WindowConfiguration& window);

}  // namespace rig_file

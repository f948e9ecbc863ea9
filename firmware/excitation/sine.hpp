// The sine of a phase accumulator as a drive signal: the polynomial of fixed_point/functions.hpp, error below 2e-8.
#pragma once
#include <cstdint>

#include "firmware/excitation/drive.hpp"
#include "firmware/fixed_point/functions.hpp"

namespace firmware {

// phase_turns: 2^32 is one whole turn and wraps by itself. The sine's 1 becomes the largest drive below 1.
inline Drive sine(uint32_t phase_turns) {
  return Drive::from_raw(clamp_magnitude(int64_t{2} * sine_of_turns(phase_turns).raw, INT32_MAX));
}
inline Drive cosine(uint32_t phase_turns) { return sine(phase_turns + 0x40000000u); }

}  // namespace firmware

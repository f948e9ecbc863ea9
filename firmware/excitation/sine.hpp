// Fixed-point sine of a phase accumulator.
//
// Equation: sin(pi/2 z) on -1 <= z <= 1 as an odd polynomial of degree 9 in z (least-maximum fit, 3.7e-9), the other
// half turn folded onto it. Arithmetic: z, z^2 and the coefficients Q2.30 in int32, products int64 (at most 2^61), each
// rounded back to Q2.30 (5 roundings of 2^-31). Error against the true sine below 1e-8; tested below 1e-6.
#pragma once
#include <cstdint>

#include "firmware/excitation/drive.hpp"

namespace firmware {

// phase_turns: 2^32 is one whole turn and wraps by itself.
Drive sine(uint32_t phase_turns);
inline Drive cosine(uint32_t phase_turns) { return sine(phase_turns + 0x40000000u); }

}  // namespace firmware

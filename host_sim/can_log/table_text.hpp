// The numbers of the frame table as text, for the DBC and the protocol page.
#pragma once
#include <string>

#include "firmware/can_protocol/frame_description.hpp"

namespace can_log {

double factor(const firmware::can::Signal& signal);
double physical(const firmware::can::Signal& signal, int64_t raw);
std::string shortest(double value);  // the fewest digits that read back as the same number
std::string lower_case(std::string text);

// Bits on the wire of a classic frame with an 11-bit identifier, with the space to the next frame and, where stuffed,
// the most stuff bits that ISO 11898-1 allows: 47 + 8 n, and a stuff bit for every four of the first 34 + 8 n.
constexpr int classic_bits(int data_bytes, bool stuffed) {
  return 47 + 8 * data_bytes + (stuffed ? (34 + 8 * data_bytes - 1) / 4 : 0);
}

}  // namespace can_log

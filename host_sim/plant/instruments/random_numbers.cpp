#include "host_sim/plant/instruments/random_numbers.hpp"

#include <cmath>

namespace host_sim {
namespace {

// Spreads neighbouring seeds and streams over all 64 bits (a bijection: multiply by odd constants, fold the high half
// in).
uint64_t spread(uint64_t bits) {
  for (int round = 0; round < 3; ++round) {
    bits ^= bits >> 32;
    bits *= 0xD6E8FEB86659FD93ULL;
  }
  return bits ^ (bits >> 32);
}

}  // namespace

RandomNumbers::RandomNumbers(uint64_t seed, uint64_t stream) : generator_(spread(spread(seed + 1) + stream)) {}

double RandomNumbers::uniform() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }

double RandomNumbers::normal() {
  if (spare_ready_) {
    spare_ready_ = false;
    return spare_;
  }
  double a = 0.0, b = 0.0, square = 0.0;
  do {
    a = 2.0 * uniform() - 1.0;
    b = 2.0 * uniform() - 1.0;
    square = a * a + b * b;
  } while (square >= 1.0 || square == 0.0);
  const double factor = std::sqrt(-2.0 * std::log(square) / square);
  spare_ = b * factor;
  spare_ready_ = true;
  return a * factor;
}

}  // namespace host_sim

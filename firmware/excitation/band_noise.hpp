// Band-limited random drive: the sum of 64 sines whose frequencies are spread over the band, one in each of 64 equal
// slots at a random place, with random starting phases. Integer only, the same seed gives the same bytes on every
// machine.
//
// Why a sum and not filtered noise: the band edges are exact, the rms is known beforehand (line amplitude * sqrt(64 /
// 2)), and no filter coefficients depend on the sample rate. The lines are not harmonics of one another, so it does not
// repeat within a test. Arithmetic: lines Q0.31, sum int64 below 2^37, times the line amplitude Q0.31 below 2^68 / 2^5:
// see next().
#pragma once
#include <cstdint>

#include "firmware/excitation/drive.hpp"

namespace firmware {

// Marsaglia's 32-bit xorshift (13, 17, 5); the state is never zero.
class RandomBits {
 public:
  void seed(uint32_t value) { state_ = value ? value : 0x9E3779B9u; }
  uint32_t next();

 private:
  uint32_t state_ = 1;
};

class BandNoise {
 public:
  static constexpr int kLines = 64;

  // Frequencies as phase steps per sample: 2^32 * f / sample rate; low < high.
  void begin(uint32_t low_step, uint32_t high_step, uint32_t seed);
  // The next sample at the given rms; int64 because peaks may exceed full scale: the caller limits them.
  int64_t next(Drive rms);

 private:
  uint32_t phase_[kLines] = {};
  uint32_t step_[kLines] = {};
};

}  // namespace firmware

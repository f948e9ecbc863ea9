// See band_noise.hpp.
#include "firmware/excitation/band_noise.hpp"

#include "firmware/excitation/sine.hpp"

namespace firmware {
namespace {

// sqrt(2 / kLines) in Q0.31: line amplitude per rms of the sum. kLines = 64: 0.176776695 * 2^31.
constexpr int64_t kLineAmplitudePerRms = 379625062;
static_assert(BandNoise::kLines == 64, "kLineAmplitudePerRms is sqrt(2 / 64)");

}  // namespace

uint32_t RandomBits::next() {
  state_ ^= state_ << 13;
  state_ ^= state_ >> 17;
  state_ ^= state_ << 5;
  return state_;
}

void BandNoise::begin(uint32_t low_step, uint32_t high_step, uint32_t seed) {
  RandomBits random;
  random.seed(seed);
  for (int i = 0; i < 8; ++i) random.next();  // neighbouring seeds part
  const uint64_t width = high_step - low_step;
  for (int line = 0; line < kLines; ++line) {
    const uint64_t place = (static_cast<uint64_t>(line) << 32) + random.next();  // slots, Q32
    step_[line] = low_step + static_cast<uint32_t>((width * (place >> 6)) >> 32);
    phase_[line] = random.next();
  }
}

int64_t BandNoise::next(Drive rms) {
  int64_t sum = 0;  // Q31, |sum| <= 64 * 2^31 = 2^37
  for (int line = 0; line < kLines; ++line) {
    sum += sine(phase_[line]).raw;
    phase_[line] += step_[line];
  }
  const int64_t amplitude = (static_cast<int64_t>(rms.raw) * kLineAmplitudePerRms) >> 31;  // Q31, below 0.177 * 2^31
  return ((sum >> 8) * amplitude) >> 23;  // (2^29 * 2^29) = 2^58, back to Q31
}

}  // namespace firmware

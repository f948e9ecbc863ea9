// The noise of a recorded channel, read from differences of high order, which leave little of a motion.
//
// Model: first-order noise, autocovariance deviation^2 * pole^|lag|. It is read at three bands of the upper half of the
// spectrum. Where these do not fit one such curve, the motion itself reaches up there and what is read is a bound; that of a
// velocity or an acceleration, whose integrals have the noise of low frequencies, is read below the motion as well. A displacement's
// noise may have passed an anti-alias filter: then it has the spectrum's own shape (filtered_noise.hpp).
#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "hal/rig_file/recorded/channel_codes.hpp"

namespace rig_file {

struct ChannelNoise {
  double deviation = 0;             // standard deviation, codes; 0: not known, there is no record that tells it
  double pole = 0;                  // 0: white
  double doubt = 1;                 // the products of this noise in the signals may be off by this share of them
  std::vector<double> correlation;  // over lags from 0, in place of the pole's; empty: first-order noise
  double correlated(size_t lag) const {
    if (correlation.empty()) return std::pow(pole, static_cast<double>(lag));
    return lag < correlation.size() ? correlation[lag] : 0.0;
  }
  bool white() const { return pole == 0.0 && correlation.empty(); }
};

using NodeNoise = std::array<std::array<ChannelNoise, firmware::kQuantities>, firmware::kMaxNodes>;  // of every channel

ChannelNoise read_noise(const ChannelCodes& records, int quantity, double rate_Hz);

// Whether the top of a displacement's spectrum holds so little, a hundred thousandth of its rms as white noise, that noise of no colour (a pole of
// 0.9 has 19 times as much) moves anything.
bool hardly_noisy(const ChannelCodes& displacement);

}  // namespace rig_file

// Link elongation and rate: u = x_a - x_b, w = v_a - v_b (ground has x = v = 0), and what Coulomb friction needs of them.
//
// Two nodes' codes may have different units. gain_a and gain_b bring them to a common one: the finer of the two divided by up
// to 32. Formats: code 24 bits (smoothed 29) times gain <= 2^28, two of them: below 2^58; shifted by 23: below 2^35, int64.
//
// The smoothed rate is w weighted with (4, 1, 10, 1, 4) / 20 over five samples: 67/200 of the white noise variance, and its
// noise has no correlation with that of the instrument (-1, 4, 0, 4, -1) / 6 it is multiplied with.
// The sign of a rate that is exactly zero is 0: half way between, so that neither direction is favoured.
#pragma once
#include "firmware/acquisition/columns.hpp"
#include "firmware/configuration/configuration.hpp"

namespace firmware {

struct RateGains {
  int32_t gain_a = 0, gain_b = 0;       // Q23
  uint16_t column_a = 0, column_b = 0;  // velocity columns of the nodes
  bool has_a = false, has_b = false;    // false: ground
};

RateGains rate_gains(const CoreConfiguration& configuration, const LinkConfiguration& link);

// w[i], in the common unit, for positions [from, to) of the frame. smoothed: 20 times the smoothed rate.
void link_rate(const RateGains& gains, const Frame& frame, bool smoothed, int from, int to, int64_t* rate);
// Whether both codes have one unit (or one end is ground): the sign of the rate is then that of a plain difference.
bool equal_units(const RateGains& gains);
// Then link_rate() is 2^kRateGuardBits times this.
constexpr int kRateGuardBits = 5;  // the common unit is up to 2^5 finer than the finer channel
void rate_of_difference(const RateGains& gains, const Frame& frame, int from, int to, int32_t* rate);
// The same signs as link_rate() and signs() give where equal_units(), without the 64-bit steps.
void signs_of_difference(const RateGains& gains, const Frame& frame, bool smoothed, int from, int to, int32_t* sign);
// -1, 0 or 1 for each.
void signs(const int64_t* rate, int from, int to, int32_t* sign);

}  // namespace firmware

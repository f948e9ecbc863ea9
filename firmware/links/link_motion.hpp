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

using Rate = Fixed<int64_t, 5>;       // of the coarser code's unit
using RateGain = Fixed<int32_t, 28>;  // likewise

struct RateGains {
  RateGain gain_a, gain_b;              // of the common unit, per code
  uint16_t column_a = 0, column_b = 0;  // velocity columns of the nodes
  bool has_a = false, has_b = false;    // false: ground
};

RateGains rate_gains(const CoreConfiguration& configuration, const LinkConfiguration& link);

// w[i], in the common unit, for positions [from, to) of the frame. smoothed: 20 times the smoothed rate.
void link_rate(const RateGains& gains, const Frame& frame, bool smoothed, int from, int to, Rate* rate);
// Whether both codes have one unit (or one end is ground): the sign of the rate is then that of a plain difference.
bool equal_units(const RateGains& gains);
// Then this is link_rate() as a difference of codes.
void rate_of_difference(const RateGains& gains, const Frame& frame, int from, int to, Code* rate);
// The same signs as link_rate() and signs() give where equal_units(), without the 64-bit steps.
void signs_of_difference(const RateGains& gains, const Frame& frame, bool smoothed, int from, int to,
                         Column<Code> sign);
// -1, 0 or 1 for each.
void signs(const Rate* rate, int from, int to, Column<Code> sign);

}  // namespace firmware

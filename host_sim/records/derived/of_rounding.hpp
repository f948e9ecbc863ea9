// Columns that were filtered out of one that is read in steps: an encoder's slope over the last few samples, smoothed by a drive.
#pragma once
#include <vector>

#include "host_sim/records/record.hpp"

namespace host_sim {

// Of the noise, or the rounding, that what is computed has of the other: it has next to none of its own, a sensor all of it. One that is
// rounded, too, is within it.
constexpr double kOwn = 0.25;

// Whether a column follows the rounding of another one, which no sensor of its own knows: at row i it is
//   y_i = sum over k of c_k s_(i+k) + sum over j of a_j y_(i+j),  k = -10 .. 9, j = -2, -1, 1, 2 (or none),
// s_i the slope of x from row i to the next (uneven steps as even ones), c and a by least squares, but for less than kOwn of what the
// rounding of x, uniform within its step q, makes of it: sqrt(sum of squared taps) q / sqrt(12). In nine rows of ten: a difference that was
// taken at another instant than the row bears is a step off now and then. t_s: instants of the rows. False where x is not read
// in steps, and where it goes through the same readings in every cycle.
bool follows_rounding(const Channel& column, const Channel& of, const std::vector<double>& t_s);

}  // namespace host_sim

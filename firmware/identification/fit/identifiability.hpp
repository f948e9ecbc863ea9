// Which parameters the data can tell apart, judged before any number is believed and without the noise: from the fit
// with start weights, in which every equation of every level counts by its energy, not by its scatter.
//
// The measure is the variance inflation of a parameter: the factor by which its standard deviation grows because the
// other parameters are unknown too. At 100 a row error of one part in a hundred - the calibration of a good sensor -
// changes the parameter by its own size, however small the noise is: ILL_CONDITIONED. (The paper's 3-DOF rig: 2 with
// two frequencies, 400 to 560 with one.)
#pragma once
#include "firmware/identification/fit/normal_equations.hpp"

namespace firmware {

// Inflation above which a parameter is ILL_CONDITIONED.
constexpr int kLargestInflation = 100;
// Short rows differ from each other by noise alone, which hides the dependence: there the inflation stops at about one
// over the relative noise of a row. So a parameter is also ILL_CONDITIONED where inflation times that noise is over 1 /
// 2: then the bias from noise in the columns can be as large as the parameter. Noise in the columns is a part of what is left of the
// rows once the discrepancies are taken off: where that, as the parameter's deviation shows it, allows less, the parameter stands.
constexpr int kLargestNoiseShare = 2;

struct Identifiability {
  Scaled inflation[kMaxUnknowns];   // 1 or more; 0 where the column is zero, fully dependent, or a part of one that is
  Scaled condition_number;          // of the column-scaled rows
  Scaled unresolved[kMaxUnknowns];  // change of parameters that the rows see least, largest relative entry 1
};

// factor: all rows are in; it is inverted here.
void judge_identifiability(NormalEquations& factor, const Scaled* parameters, Identifiability& result);

}  // namespace firmware

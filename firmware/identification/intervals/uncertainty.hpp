// Standard deviation and 95 % interval of every parameter from the measured scatter.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/fit/weighted_fit.hpp"

namespace firmware {

constexpr int kLeastLevels = 3;  // that show a scatter of their own

// Variance of p_k = sum over equations of (share of the equation in the covariance) * inflation; degrees of freedom
// after Welch and Satterthwaite. The weights of the equations are themselves estimated from n degrees of freedom each: with
// shares s of the variance it is 1 + 4 sum of s (1 - s) / n times as large (Meier, Biometrics 9, 1953). Where no scatter could be measured the residuals of the fit give the scale.
struct UncertaintySums {
  // Of each parameter; they stand where its deviation and interval will.
  Scaled& variance(int k) { return estimates->parameters[k].std; }
  Scaled& variance_per_freedom(int k) { return estimates->parameters[k].ci95_low; }
  Scaled& variance_square_per_freedom(int k) { return estimates->parameters[k].ci95_high; }
  Estimates* estimates = nullptr;
  // Of one level: what its residuals pull the parameter by; over all levels: sum of pull squares. Fewer levels do not tell.
  static constexpr bool kPulls = kMaxLevels >= kLeastLevels;
  Scaled pull[kPulls ? kMaxUnknowns : 1], pull_square[kPulls ? kMaxUnknowns : 1];
  Scaled relative_residuals;
  uint32_t rows = 0;
  uint32_t relative_rows = 0;
  int levels = 0;  // with batches
  bool periodic = true;
};

void begin_uncertainty(UncertaintySums& sums, Estimates& estimates);
// Adds the level l that the fit has loaded.
void add_uncertainty(const EquationList& list, const LevelColumns& level, int l, WeightedFit& fit,
                     UncertaintySums& sums);
// Fills value, std, interval, rows, residual_mean_abs.
void report_uncertainty(const EquationList& list, const WeightedFit& fit, UncertaintySums& sums);

}  // namespace firmware

// What the estimator says: numbers with their uncertainty and whether to believe them.
#pragma once
#include <cstdint>

#include "firmware/configuration/capacity.hpp"
#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

// In rising order of severity: a parameter shows the gravest that applies.
enum class EstimateStatus : uint8_t {
  kValid = 0,
  kStale = 1,           // no window closed since the last report
  kBiasSuspect = 2,     // plain and instrumented estimates differ by more than their scatter allows
  kSkewed = 3,          // channels are skewed in time and the skew is not compensated
  kIllConditioned = 4,  // the data cannot separate this parameter from others
  kNoExcitation = 5,    // the parameter's link does not move
  kSaturated = 6,       // a sensor or an accumulator reached its limit
};

struct ParameterEstimate {
  Scaled value;                 // SI units
  Scaled std;                   // standard deviation from the measured scatter
  Scaled ci95_low, ci95_high;   // 95 % interval
  EstimateStatus status = EstimateStatus::kStale;
};

struct Estimates {
  uint8_t unknown_count = 0;
  ParameterEstimate parameters[kMaxUnknowns];
  Scaled condition_number;      // of the column-scaled rows
  Scaled residual_mean_abs;     // mean |A p - U| / |U| over the rows (the paper's normalised residual)
  uint32_t window_counter = 0;  // closed windows so far
  uint32_t rows = 0;            // energy equations used
};

}  // namespace firmware

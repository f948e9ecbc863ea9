// What the estimator says: numbers with their uncertainty and whether to believe them.
#pragma once
#include <cstdint>

#include "firmware/configuration/capacity.hpp"
#include "firmware/fixed_point/scaled.hpp"
#include "firmware/vocabulary/cause.hpp"

namespace firmware {

// The numbers travel on CAN. A parameter shows the gravest that applies, see severity().
enum class EstimateStatus : uint8_t {
  kValid = 0,
  kStale = 1,           // no window closed since the last report, or with nothing new in it
  kBiasSuspect = 2,     // plain and instrumented estimates differ by more than their scatter allows
  kSkewed = 3,          // channels are skewed in time and the skew is not compensated
  kIllConditioned = 4,  // the data cannot separate this parameter from others
  kNoExcitation = 5,    // the parameter's link does not move
  kSaturated = 6,       // a sensor or an accumulator reached its limit
  kModelSuspect = 7,    // the data contradict the rig's model or a channel in a way that may bend this parameter
  kUntested = 8,        // the data cannot test the model: what it may lack would not show
};

constexpr int severity(EstimateStatus status) {
  switch (status) {
    case EstimateStatus::kValid:
      return 0;
    case EstimateStatus::kStale:
      return 1;
    case EstimateStatus::kUntested:
      return 2;
    case EstimateStatus::kBiasSuspect:
      return 3;
    case EstimateStatus::kSkewed:
      return 4;
    case EstimateStatus::kModelSuspect:
      return 5;
    case EstimateStatus::kIllConditioned:
      return 6;
    case EstimateStatus::kNoExcitation:
      return 7;
    case EstimateStatus::kSaturated:
      return 8;
  }
  return 8;
}

struct ParameterEstimate {
  Scaled value;                // SI units
  Scaled std;                  // standard deviation from the measured scatter
  Scaled ci95_low, ci95_high;  // 95 % interval: Student's t with the degrees of freedom of the scatter
  Scaled plain_value;          // with the plain product (the paper's) instead of the instrument: biased by noise
  Scaled variance_inflation;   // root of the variance ratio: other parameters unknown against known
  EstimateStatus status = EstimateStatus::kStale;
};

// An error that no scatter shows, as a further standard deviation.
inline void widen(ParameterEstimate& parameter, const Scaled& deviation) {
  if (parameter.std.is_zero()) return;
  const Scaled wider = root_of_squares(parameter.std, deviation);
  const Scaled half = scale_by_power_of_two(parameter.ci95_high - parameter.ci95_low, -1) * wider / parameter.std;
  parameter.std = wider;
  parameter.ci95_low = parameter.value - half;
  parameter.ci95_high = parameter.value + half;
}

// How late a channel of a DOF is against its velocity, from identities that need no model of the rig.
struct SkewEstimate {
  bool measured = false;     // both channels are there and move
  bool significant = false;  // over twice its 95 % interval and over what friction imitates
  Scaled late_s;             // positive: the channel is late against the velocity
  Scaled std_s;
};

enum class Advice : uint8_t {
  kNone = 0,
  kAddFrequency = 1,    // argument: a frequency in Hz near which to excite as well
  kAddLevel = 2,        // another excitation level of the same kind
  kRaiseLevel = 3,      // argument: the unknown whose link hardly moves
  kLongerRecord = 4,    // too few batches to measure any scatter
  kLowerLevel = 5,      // sensors are saturated
  kCompensateSkew = 6,  // argument: the DOF with the largest skew
};

// What the data say of the rig's model.
struct Finding {
  Cause cause = Cause::kNone;
  int8_t node_a = -1, node_b = -1;  // the ends of a link; a DOF alone; -1: none
  uint8_t quantity = kNoQuantity;   // of the channel at node_a, where the cause is in the measurement
  Scaled size, std;                 // SI units of the vocabulary's row
};
// Whether the named cause is the cause, or only the nearest of all candidates to something that the model lacks.
enum class Naming : uint8_t {
  kExplains = 0,  // what it leaves is noise, and nothing stands out more
  kInPart = 1,    // it leaves more than noise
  kOutdone = 2,   // another force stands out more
  kTakenUp = 3,   // the estimated coefficients take up most of it, and the rest is what integration makes of noise
  kNoFault = 4,  // of a channel that nobody measures, or larger than a fault of its kind can be; a force that cannot be
};
struct Warrant {
  bool tested = false;  // there was enough to test the model with
  bool confirmed =
      true;  // of a late acceleration beside a force: the equation of motion says so too, it is no held force
  bool corrected =
      false;  // named is a channel's fault that has been taken out of these estimates; nothing else is found
  Naming naming = Naming::kExplains;
  Finding named, rival;  // the cause that explains the residual best; the next best that is no other word for it
  // Force of the named cause over the damping force beside it; what it takes away of what stands out along its force beyond noise, 0
  // to 1; what the rival takes away, as a share of what the named cause does.
  Scaled force_ratio, gained, rival_share;
};

struct Estimates {
  Estimates();  // out of line: its initial values take room once
  uint8_t unknown_count = 0;
  ParameterEstimate parameters[kMaxUnknowns];
  Scaled condition_number;      // of the column-scaled rows
  Scaled residual_mean_abs;     // mean |A p - U| / |U| over the rows (the paper's normalised residual)
  uint32_t window_counter = 0;  // closed windows so far
  uint32_t rows = 0;            // energy equations used
  bool inseparable = false;     // the data cannot tell some of the parameters apart

  Scaled unresolved[kMaxUnknowns];  // the combination of parameters seen worst; its largest entry is 1, the entries are
                                    // changes relative to each parameter's own value
  Advice advice = Advice::kNone;
  int32_t advice_index = -1;  // an unknown or a DOF, see Advice
  Scaled advice_frequency_Hz;
  SkewEstimate displacement_skew[kMaxDofs];
  SkewEstimate acceleration_skew[kMaxDofs];
  Warrant warrant;
};

// To what they are before anything is known: every status STALE.
void clear(Warrant& warrant);
void clear(Estimates& estimates);

}  // namespace firmware

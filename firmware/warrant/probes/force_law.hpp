// The force laws of the probes, a loop over the block's samples for each, so that none has a choice of form inside. Laws that differ in
// the quantity alone that they are of share one.
//
// Formats: u and w in Q18 of their units, at most 2^23 and what sum_slopes() moves them by; a sign in Q20. Forces as force_exponent()
// says (probe_force.hpp).
#pragma once
#include "firmware/fixed_point/functions.hpp"
#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/warrant/probes/probe.hpp"

namespace firmware {

constexpr int kProbeFraction = 18;  // of the normalised quantities
constexpr int kSignBits = 20;
constexpr int64_t kProbeUnit = 1 << kProbeFraction;
constexpr int64_t kGap = kProbeUnit / 8, kStop = kProbeUnit + kProbeUnit / 4;
constexpr int kReversalDeviations = 4;  // of the rate's noise: closer to a reversal a sign is not known
// log2(e) / v in Q26 per unit of |w| in Q18, v = 0.15 and 0.5 units.
constexpr int64_t kNarrow = 2462, kWide = 739;
constexpr int64_t kNarrowRate = kProbeUnit * 15 / 100;

constexpr bool has_sign(Form form) {
  return form == Form::kSign || form == Form::kSignNarrow || form == Form::kSignWide || form == Form::kSignElongation;
}
constexpr bool is_slope(Form form) { return form == Form::kJerk || form == Form::kForceRate; }
constexpr bool is_of_rate(Form form) {
  return form == Form::kRate || form == Form::kRateSquare || form == Form::kRateCube || form == Form::kRateMagnitude ||
         form == Form::kElongationSquareRate || form == Form::kForce || form == Form::kForceWithinGap;
}

inline int32_t probe_square(int32_t x) { return static_cast<int32_t>((int64_t{x} * x) >> 22); }  // Q14
// x^2 y, Q9
inline int32_t probe_cube(int32_t x, int32_t y) { return static_cast<int32_t>((int64_t{probe_square(x)} * y) >> 23); }
// Below 2^-20 nothing is left.
inline int32_t sign_decay(int32_t w, int64_t per_unit) {
  if (size_of(w) * per_unit >= int64_t{kSignBits} << 26) return 0;
  return exp2_of_minus(Fixed<int64_t, 26>::from_raw(size_of(w) * per_unit)).raw >> (30 - kSignBits);
}
constexpr int32_t within(int32_t value, int32_t limit) {
  return value > limit ? limit : value < -limit ? -limit : value;
}

// The law's force from the place's two quantities and the direction of its rate; zero where the sample is not used. A slope is no law
// of them.
inline void fill_law(Form form, const int32_t (&quantity)[2][kBlockSamples], const int32_t* sign, const int32_t* used,
                     int32_t* force) {
  const int32_t *const u = quantity[0], *const w = quantity[1];
  const int32_t* const x = is_of_rate(form) ? w : u;
  const auto fill = [&](auto law) {
    for (int n = 0; n < kBlockSamples; ++n) force[n] = law(n) & used[n];
  };
  switch (form) {
    case Form::kElongation:
    case Form::kAcceleration:
    case Form::kRate:
    case Form::kForce:
      return fill([&](int n) { return x[n]; });
    case Form::kElongationSquare:
      return fill([&](int n) { return probe_square(u[n]); });
    case Form::kRateSquare:
      return fill([&](int n) { return w[n] < 0 ? -probe_square(w[n]) : probe_square(w[n]); });
    case Form::kElongationCube:
    case Form::kRateCube:
      return fill([&](int n) { return probe_cube(x[n], x[n]); });
    case Form::kElongationSquareRate:
      return fill([&](int n) { return probe_cube(u[n], w[n]); });
    case Form::kWithinGap:
    case Form::kForceWithinGap:
      return fill([&](int n) { return within(x[n], kGap); });
    case Form::kBeyondStop:
      return fill([&](int n) { return u[n] - within(u[n], kStop); });
    case Form::kConstant:
      return fill([](int) { return 1 << kSignBits; });
    case Form::kRateMagnitude:
      return fill([&](int n) { return w[n] < 0 ? -w[n] : w[n]; });
    case Form::kSign:
      return fill([&](int n) { return sign[n]; });
    case Form::kSignNarrow:
    case Form::kSignWide: {
      const int64_t per_unit = form == Form::kSignNarrow ? kNarrow : kWide;
      return fill([&](int n) {
        return sign[n] == 0 ? 0 : static_cast<int32_t>((int64_t{sign[n]} * sign_decay(w[n], per_unit)) >> kSignBits);
      });
    }
    case Form::kSignElongation:
      return fill(
          [&](int n) { return static_cast<int32_t>((int64_t{sign[n]} * (u[n] < 0 ? -u[n] : u[n])) >> kSignBits); });
    case Form::kJerk:
    case Form::kForceRate:
      return;
  }
}

}  // namespace firmware

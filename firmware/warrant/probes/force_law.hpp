// The force laws of the probes, one function a form, so that a loop over samples has no choice of form inside.
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

inline int64_t probe_square(int64_t x) { return (x * x) >> 22; }  // Q14
// Below 2^-20 nothing is left.
inline int64_t sign_decay(int64_t w, int64_t per_unit) {
  if (size_of(w) * per_unit >= int64_t{kSignBits} << 26) return 0;
  return exp2_of_minus(Fixed<int64_t, 26>::from_raw(size_of(w) * per_unit)).raw >> (30 - kSignBits);
}

template <typename Number>
constexpr Number within(Number value, Number limit) {
  return value > limit ? limit : value < -limit ? -limit : value;
}

// sign: of the rate.
template <Form form>
inline int64_t force_law(int32_t u, int32_t w, int32_t sign) {
  if constexpr (form == Form::kElongation || form == Form::kAcceleration) return u;
  if constexpr (form == Form::kElongationSquare) return probe_square(u);
  if constexpr (form == Form::kElongationCube) return (probe_square(u) * u) >> 23;
  if constexpr (form == Form::kWithinGap) return within<int32_t>(u, kGap);
  if constexpr (form == Form::kBeyondStop) return u - within<int32_t>(u, kStop);
  if constexpr (form == Form::kForceWithinGap) return within<int32_t>(w, kGap);
  if constexpr (form == Form::kConstant) return 1 << kSignBits;
  if constexpr (form == Form::kRate || form == Form::kForce) return w;
  if constexpr (form == Form::kRateSquare) return w < 0 ? -probe_square(w) : probe_square(w);
  if constexpr (form == Form::kRateCube) return (probe_square(w) * w) >> 23;
  if constexpr (form == Form::kRateMagnitude) return w < 0 ? -w : w;
  if constexpr (form == Form::kElongationSquareRate) return (probe_square(u) * w) >> 23;
  if constexpr (form == Form::kSign) return sign;
  if constexpr (form == Form::kSignNarrow) return sign == 0 ? 0 : (sign * sign_decay(w, kNarrow)) >> kSignBits;
  if constexpr (form == Form::kSignWide) return sign == 0 ? 0 : (sign * sign_decay(w, kWide)) >> kSignBits;
  if constexpr (form == Form::kSignElongation) return (int64_t{sign} * (u < 0 ? -u : u)) >> kSignBits;
  return 0;  // a slope is no law of u and w
}

// call(f): f.form is the form, known to the compiler.
template <Form f>
struct KnownForm {
  static constexpr Form form = f;
};
template <typename Call>
void with_form(Form form, Call call) {
  switch (form) {
    case Form::kElongation:
      return call(KnownForm<Form::kElongation>{});
    case Form::kElongationSquare:
      return call(KnownForm<Form::kElongationSquare>{});
    case Form::kElongationCube:
      return call(KnownForm<Form::kElongationCube>{});
    case Form::kWithinGap:
      return call(KnownForm<Form::kWithinGap>{});
    case Form::kBeyondStop:
      return call(KnownForm<Form::kBeyondStop>{});
    case Form::kConstant:
      return call(KnownForm<Form::kConstant>{});
    case Form::kRate:
      return call(KnownForm<Form::kRate>{});
    case Form::kRateSquare:
      return call(KnownForm<Form::kRateSquare>{});
    case Form::kRateCube:
      return call(KnownForm<Form::kRateCube>{});
    case Form::kRateMagnitude:
      return call(KnownForm<Form::kRateMagnitude>{});
    case Form::kElongationSquareRate:
      return call(KnownForm<Form::kElongationSquareRate>{});
    case Form::kSign:
      return call(KnownForm<Form::kSign>{});
    case Form::kSignNarrow:
      return call(KnownForm<Form::kSignNarrow>{});
    case Form::kSignWide:
      return call(KnownForm<Form::kSignWide>{});
    case Form::kSignElongation:
      return call(KnownForm<Form::kSignElongation>{});
    case Form::kAcceleration:
      return call(KnownForm<Form::kAcceleration>{});
    case Form::kForce:
      return call(KnownForm<Form::kForce>{});
    case Form::kForceWithinGap:
      return call(KnownForm<Form::kForceWithinGap>{});
    case Form::kJerk:
      return call(KnownForm<Form::kJerk>{});
    case Form::kForceRate:
      return call(KnownForm<Form::kForceRate>{});
  }
}

}  // namespace firmware

#include "firmware/warrant/probe_force.hpp"

#include "firmware/fixed_point/functions.hpp"
#include "firmware/fixed_point/magnitude.hpp"

namespace firmware {
namespace {

constexpr int kFraction = 18;  // of the normalised quantities
constexpr int64_t kUnit = 1 << kFraction, kMost = 32 * kUnit;
constexpr int kPureFraction = 20;
constexpr int64_t kGap = kUnit / 8, kStop = kUnit + kUnit / 4;
constexpr int kReversalDeviations = 4;  // of the rate's noise: closer to a reversal a sign is not known
// log2(e) / v in Q26 per unit of |w| in Q18, v = 0.15 and 0.5 units.
constexpr int64_t kNarrow = 2462, kWide = 739;
constexpr int64_t kNarrowRate = kUnit * 15 / 100;

int32_t normalised(int32_t q26, int shift) {
  const int64_t value = shift >= 0 ? int64_t{q26} >> shift : int64_t{q26} * (int64_t{1} << -shift);
  return static_cast<int32_t>(limited(value, kMost));
}
int64_t square(int64_t x) { return (x * x) >> 22; }  // Q14
int64_t decay(int64_t w, int64_t per_unit) {
  return exp2_of_minus(Fixed<int64_t, 26>::from_raw(size_of(w) * per_unit)).raw >> (30 - kPureFraction);
}

// sign: of the rate, Q20.
int64_t law(Form form, int64_t u, int64_t w, int64_t sign) {
  switch (form) {
    case Form::kElongation:
    case Form::kAcceleration:
      return u;
    case Form::kElongationSquare:
      return square(u);
    case Form::kElongationCube:
      return (square(u) * u) >> 23;
    case Form::kWithinGap:
      return limited(u, kGap);
    case Form::kBeyondStop:
      return u - limited(u, kStop);
    case Form::kConstant:
      return 1 << kPureFraction;
    case Form::kRate:
    case Form::kForce:
      return w;
    case Form::kRateSquare:
      return w < 0 ? -square(w) : square(w);
    case Form::kRateCube:
      return (square(w) * w) >> 23;
    case Form::kRateMagnitude:
      return size_of(w);
    case Form::kElongationSquareRate:
      return (square(u) * w) >> 23;
    case Form::kSign:
      return sign;
    case Form::kSignNarrow:
      return (sign * decay(w, kNarrow)) >> kPureFraction;
    case Form::kSignWide:
      return (sign * decay(w, kWide)) >> kPureFraction;
    case Form::kSignElongation:
      return (sign * size_of(u)) >> kPureFraction;
    case Form::kJerk:
    case Form::kForceRate:
      return 0;
  }
  return 0;
}

}  // namespace

namespace {

// Friction's jump lies within the reach of the slope that made the acceleration, which then holds a part of either side. Told
// by the slope's outermost samples: they have a 200th of its weight, so that the choice hardly knows the noise of the slope.
bool across_a_reversal(const NodeDifference& rate, const int32_t* a, const int32_t* b, int n) {
  const int32_t before = difference_at(rate, a, b, n - kNeighbours), after = difference_at(rate, a, b, n + kNeighbours);
  return (before > 0) != (after > 0);
}

}  // namespace

void fill_motion(const BlockMotion& block, const Place& place, const PlaceScale& scale, PlaceMotion& motion) {
  for (int q = 0; q < 2; ++q) {
    const NodeDifference& d = scale.difference[q];
    const int32_t *a = block.signal(d.column_a), *b = block.signal(d.column_b);
    for (int n = 0; n < kBlockSamples; ++n) {
      const bool inside = scale.present[q];
      motion.instrument[q][n] = inside ? normalised(smoothed(d, a, b, n), scale.shift[q]) : 0;
      motion.own[q][n] = inside ? normalised(difference_at(d, a, b, n), scale.shift[q]) : 0;
      if (place.kind != PlaceKind::kDof) continue;
      motion.slope[q][n] = inside ? normalised(slope(d, a, n), scale.shift[q]) : 0;
      const int32_t twice = difference_at(d, a, b, n + 1) / 2 - difference_at(d, a, b, n - 1) / 2;
      motion.own_slope[q][n] = inside ? normalised(twice, scale.shift[q]) : 0;
    }
  }
  const int64_t close = scale.near_friction ? int64_t{kReversalDeviations} * scale.noise_q26 : 0;
  const int64_t limit = scale.shift[1] >= 0 ? close >> scale.shift[1] : close << -scale.shift[1];
  for (int n = 0; n < kBlockSamples; ++n) {
    bool used = !scale.near_friction || size_of(motion.instrument[1][n]) > limit;
    for (int e = 0; e < place.equations; ++e) used = used && block.counts(place.dof[e], n);
    if (used && scale.smeared) {
      const NodeDifference& rate = scale.difference[1];
      used = !across_a_reversal(rate, block.signal(rate.column_a), block.signal(rate.column_b), n);
    }
    motion.used[n] = used;
  }
}

namespace {

bool has_sign(Form form) {
  return form == Form::kSign || form == Form::kSignNarrow || form == Form::kSignWide || form == Form::kSignElongation;
}
bool is_slope(Form form) { return form == Form::kJerk || form == Form::kForceRate; }

int64_t rate_noise(const PlaceScale& scale) {
  return scale.shift[1] >= 0 ? scale.noise_q26 >> scale.shift[1]
                             : static_cast<int64_t>(scale.noise_q26) << -scale.shift[1];
}

// From the instruments: close to a reversal a sign is not known.
int64_t instrument_force(Form form, int64_t u, int64_t w, int64_t noise) {
  if (has_sign(form) && size_of(w) <= kReversalDeviations * noise) return 0;
  if (form == Form::kSignNarrow && kReversalDeviations * noise > kNarrowRate) return 0;  // over where signs are known
  return law(form, u, w, ((w > 0) - (w < 0)) * (1 << kPureFraction));
}

}  // namespace

void fill_force(Form form, const PlaceScale& scale, const PlaceMotion& motion, int32_t* phi, int32_t* own) {
  const int64_t noise = rate_noise(scale), width = noise + noise / 4;
  const int slope_of = form == Form::kJerk ? 0 : 1;
  for (int n = 0; n < kBlockSamples; ++n) {
    if (!motion.used[n]) {
      phi[n] = own[n] = 0;
      continue;
    }
    if (is_slope(form)) {
      phi[n] = motion.slope[slope_of][n];
      own[n] = motion.own_slope[slope_of][n];
      continue;
    }
    const int64_t own_w = motion.own[1][n];
    const int64_t own_sign = width > 0 && size_of(own_w) < width ? own_w * (1 << kPureFraction) / width
                                                                 : ((own_w > 0) - (own_w < 0)) * (1 << kPureFraction);
    phi[n] = static_cast<int32_t>(instrument_force(form, motion.instrument[0][n], motion.instrument[1][n], noise));
    own[n] = static_cast<int32_t>(law(form, motion.own[0][n], own_w, own_sign));
  }
}

void sum_slopes(Form form, const PlaceScale& scale, const PlaceMotion& motion, int64_t* first, int64_t* second) {
  constexpr int64_t h = int64_t{1} << kSlopeStepLog2;
  const int64_t noise = rate_noise(scale);
  for (int n = 0; n < kBlockSamples; ++n) {
    if (!motion.used[n]) continue;
    if (is_slope(form)) {
      *first += 2 * h;
      continue;
    }
    const int64_t u = motion.instrument[0][n], w = motion.instrument[1][n];
    *first += instrument_force(form, u + h, w, noise) - instrument_force(form, u - h, w, noise);
    *second += instrument_force(form, u, w + h, noise) - instrument_force(form, u, w - h, noise);
  }
}

int32_t quantity_exponent(const PlaceScale& scale, int quantity) {
  return scale.difference[quantity].range_exponent - kDifferenceFraction + scale.shift[quantity];
}

int32_t force_exponent(Form form, const PlaceScale& scale) {
  const int32_t u = quantity_exponent(scale, 0), w = quantity_exponent(scale, 1);
  switch (form) {
    case Form::kElongationSquare:
      return 2 * u + 22;
    case Form::kElongationCube:
      return 3 * u + 45;
    case Form::kRate:
    case Form::kRateMagnitude:
    case Form::kForce:
    case Form::kForceRate:
      return w;
    case Form::kRateSquare:
      return 2 * w + 22;
    case Form::kRateCube:
      return 3 * w + 45;
    case Form::kElongationSquareRate:
      return 2 * u + w + 45;
    case Form::kConstant:
    case Form::kSign:
    case Form::kSignNarrow:
    case Form::kSignWide:
      return -kPureFraction;
    default:
      return u;
  }
}

}  // namespace firmware

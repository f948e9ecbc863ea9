#include "firmware/links/effect_laws.hpp"

#include "firmware/fixed_point/functions.hpp"
#include "firmware/fixed_point/magnitude.hpp"

namespace firmware {
namespace {

int64_t product(int64_t a, int64_t b) { return (a * b) >> kLawFraction; }
int64_t size_of(int64_t x) { return static_cast<int64_t>(magnitude(x)); }  // far from 2^63 here
int64_t clamp(int64_t x, int64_t limit) { return x > limit ? limit : (x < -limit ? -limit : x); }
int sign(int64_t x) { return (x > 0) - (x < 0); }
int64_t exponential_q26(int64_t log2_q26) { return exp2_of_minus(log2_q26).raw >> (30 - kLawFraction); }
int32_t narrow(int64_t x) { return static_cast<int32_t>(x); }

int32_t sine(const LawPoint& at, const LawShape& shape) {
  return sine_of_turns(static_cast<uint32_t>(times(shape.ratio, at.u)) + shape.phase).raw >> (30 - kLawFraction);
}
int32_t cubic_spring(const LawPoint& at, const LawShape&) { return narrow(product(product(at.u, at.u), at.u)); }
int32_t quadratic_spring(const LawPoint& at, const LawShape&) { return narrow(product(at.u, at.u)); }
int32_t gap_lost(const LawPoint& at, const LawShape& shape) { return narrow(-clamp(at.u, shape.gap_q26)); }
int32_t beyond_gap(const LawPoint& at, const LawShape& shape) { return narrow(at.u - clamp(at.u, shape.gap_q26)); }
int32_t quadratic_damper(const LawPoint& at, const LawShape&) { return narrow(product(size_of(at.w), at.w)); }
int32_t cubic_damper(const LawPoint& at, const LawShape&) { return narrow(product(product(at.w, at.w), at.w)); }
int32_t stribeck(const LawPoint& at, const LawShape& shape) {
  return narrow(sign(at.w) * exponential_q26(times(shape.ratio, size_of(at.w))));
}
int32_t constant(const LawPoint&, const LawShape&) { return narrow(kLawOne); }
int32_t one_way_damper(const LawPoint& at, const LawShape&) { return narrow(size_of(at.w)); }
int32_t displaced_damper(const LawPoint& at, const LawShape&) { return narrow(product(product(at.u, at.u), at.w)); }
int32_t drifting_damper(const LawPoint& at, const LawShape& shape) {
  if (shape.ratio.mantissa != 0)  // tau (1 - exp(-t / tau)), in units of tau
    return narrow(product(at.w, kLawOne - exponential_q26(times(shape.ratio, at.time))));
  const int64_t limited = at.time < (1u << kLawTimeBits) ? at.time : (1 << kLawTimeBits);
  return narrow((at.w * limited) >> kLawTimeBits);
}

constexpr int kFirst = static_cast<int>(TermKind::kGravity);
constexpr CoreLaw kLaws[] = {
    {TermKind::kGravity, 0, 0, ShapeUse::kTurns, sine},
    {TermKind::kCubicStiffness, 3, 0, ShapeUse::kNone, cubic_spring},
    {TermKind::kQuadraticStiffness, 2, 0, ShapeUse::kNone, quadratic_spring},
    {TermKind::kBacklash, 1, 0, ShapeUse::kGap, gap_lost},
    {TermKind::kEndStop, 1, 0, ShapeUse::kGap, beyond_gap},
    {TermKind::kQuadraticDamping, 0, 2, ShapeUse::kNone, quadratic_damper},
    {TermKind::kCubicDamping, 0, 3, ShapeUse::kNone, cubic_damper},
    {TermKind::kStribeck, 0, 0, ShapeUse::kDecayOfRate, stribeck},
    {TermKind::kPreslidingHysteresis, 0, 0, ShapeUse::kDecayOfElongation, nullptr},
    {TermKind::kForceOffset, 0, 0, ShapeUse::kNone, constant},
    {TermKind::kAsymmetricViscous, 0, 1, ShapeUse::kNone, one_way_damper},
    {TermKind::kDisplacementDependentDamping, 2, 1, ShapeUse::kNone, displaced_damper},
    {TermKind::kDriftingViscous, 0, 1, ShapeUse::kDecayOfTime, drifting_damper},
    {TermKind::kCogging, 0, 0, ShapeUse::kTurns, sine},
};
constexpr bool in_order() {
  for (int i = kFirst; i < kTermKinds; ++i)
    if (static_cast<int>(kLaws[i - kFirst].kind) != i) return false;
  return true;
}
static_assert(sizeof(kLaws) / sizeof(kLaws[0]) == kTermKinds - kFirst, "one law for each column");
static_assert(in_order(), "laws in the order of TermKind");

}  // namespace

const CoreLaw& core_law(TermKind kind) { return kLaws[static_cast<int>(kind) - kFirst]; }

int64_t bent_bristles(int64_t z_q26, int64_t step_q26, const LawShape& shape) {
  if (step_q26 == 0) return z_q26;
  const int64_t towards = sign(step_q26) * kLawOne;
  return towards + product(z_q26 - towards, exponential_q26(times(shape.ratio, size_of(step_q26))));
}

}  // namespace firmware

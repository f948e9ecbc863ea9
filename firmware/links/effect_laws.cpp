#include "firmware/links/effect_laws.hpp"

#include "firmware/fixed_point/functions.hpp"

namespace firmware {
namespace {

// To nearest: what is small against its range would have a mean of half a step below nought.
constexpr int64_t rounded(int64_t raw, int shift) { return (raw + (int64_t{1} << (shift - 1))) >> shift; }
LawNumber product(LawNumber a, LawNumber b) { return LawNumber::from_raw(rounded(a.raw * b.raw, kLawFraction)); }
// Of two at most one in size to Q32, with the third 2^58.
LawNumber product(LawNumber a, LawNumber b, LawNumber c) {
  constexpr int kMoreBits = 6;
  const int64_t of_two = rounded(a.raw * b.raw, kLawFraction - kMoreBits);
  return LawNumber::from_raw(rounded(of_two * c.raw, kLawFraction + kMoreBits));
}
LawNumber exponential(LawNumber log2) { return LawNumber::from_raw(exp2_of_minus(log2).raw >> (30 - kLawFraction)); }
LawNumber times(LawRatio ratio, LawNumber x) { return LawNumber::from_raw(times(ratio, x.raw)); }
LawForce force(LawNumber x) { return LawForce::from_raw(static_cast<int32_t>(x.raw)); }

LawForce sine(const LawPoint& at, const LawShape& shape) {
  return LawForce::from_raw(sine_of_turns(static_cast<uint32_t>(times(shape.ratio, at.u.raw)) + shape.phase).raw >>
                            (30 - kLawFraction));
}
LawForce cubic_spring(const LawPoint& at, const LawShape&) { return force(product(at.u, at.u, at.u)); }
LawForce quadratic_spring(const LawPoint& at, const LawShape&) { return force(product(at.u, at.u)); }
LawForce gap_lost(const LawPoint& at, const LawShape& shape) { return force(-limited(at.u, shape.gap)); }
LawForce beyond_gap(const LawPoint& at, const LawShape& shape) { return force(at.u - limited(at.u, shape.gap)); }
LawForce quadratic_damper(const LawPoint& at, const LawShape&) { return force(product(size_of(at.w), at.w)); }
LawForce cubic_damper(const LawPoint& at, const LawShape&) { return force(product(at.w, at.w, at.w)); }
LawForce stribeck(const LawPoint& at, const LawShape& shape) {
  return force(sign_of(at.w) * exponential(times(shape.ratio, size_of(at.w))));
}
LawForce constant(const LawPoint&, const LawShape&) { return force(kLawOne); }
LawForce one_way_damper(const LawPoint& at, const LawShape&) { return force(size_of(at.w)); }
LawForce displaced_damper(const LawPoint& at, const LawShape&) { return force(product(at.u, at.u, at.w)); }
LawForce drifting_damper(const LawPoint& at, const LawShape& shape) {
  if (shape.ratio.mantissa != 0)  // tau (1 - exp(-t / tau)), in units of tau
    return force(product(at.w, kLawOne - exponential(LawNumber::from_raw(times(shape.ratio, int64_t{at.time})))));
  const int64_t limited_time = at.time < (1u << kLawTimeBits) ? at.time : (1 << kLawTimeBits);
  return force(LawNumber::from_raw((at.w.raw * limited_time) >> kLawTimeBits));
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

bool reads_elongation(TermKind kind) {
  if (static_cast<int>(kind) < kFirst) return kind == TermKind::kStiffness;
  const CoreLaw& law = core_law(kind);
  const bool shaped =
      law.use == ShapeUse::kGap || law.use == ShapeUse::kTurns || law.use == ShapeUse::kDecayOfElongation;
  return law.u_power != 0 || shaped;
}

LawNumber bent_bristles(LawNumber z, LawNumber step, const LawShape& shape) {
  if (step == LawNumber{}) return z;
  const LawNumber towards = sign_of(step) * kLawOne;
  return towards + product(z - towards, exponential(times(shape.ratio, size_of(step))));
}

}  // namespace firmware

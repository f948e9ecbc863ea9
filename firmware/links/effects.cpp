#include "firmware/links/effects.hpp"

#include "firmware/energy/equation_plan.hpp"
#include "firmware/fixed_point/functions.hpp"

namespace firmware {
namespace {

constexpr int kFraction = 26;
constexpr int64_t kOne = int64_t{1} << kFraction;
constexpr int kGainShift = 25;
constexpr int kTimeBits = 20;  // time runs to 2^20 samples, then stands

int64_t product(int64_t a, int64_t b) { return (a * b) >> kFraction; }
int64_t magnitude(int64_t x) { return x < 0 ? -x : x; }
int64_t clamp(int64_t x, int64_t limit) { return x > limit ? limit : (x < -limit ? -limit : x); }
int sign(int64_t x) { return (x > 0) - (x < 0); }
int64_t exponential_q26(int64_t log2_q26) { return exp2_of_minus(log2_q26).raw >> (30 - kFraction); }

// log2(e) and 1 / (2 pi), from their continued fractions: error below 1e-12.
Scaled log2_e() { return Scaled::ratio(1865452, 1293033); }
Scaled turns_per_radian() { return Scaled::ratio(265381, 1667438); }

}  // namespace

Effects::Side Effects::side(const CoreConfiguration& configuration, const LinkConfiguration& link, Quantity quantity) {
  Side side;
  const int index = static_cast<int>(quantity);
  const bool has_a = link.node_a != kGroundNode, has_b = link.node_b != kGroundNode;
  const Scaled unit_a = has_a ? configuration.signals[link.node_a][index].unit_per_code : Scaled{};
  const Scaled unit_b = has_b ? configuration.signals[link.node_b][index].unit_per_code : Scaled{};
  const Scaled sum = unit_a + unit_b;
  if (sum.is_zero()) return side;
  side.range_exponent = log2_floor(sum) + 1 + 23;  // signals stay within 2^23 codes
  const int bits = kFraction + kGainShift - side.range_exponent;
  side.gain_a = static_cast<int32_t>(to_fixed(unit_a, bits));
  side.gain_b = static_cast<int32_t>(to_fixed(unit_b, bits));
  side.column_a = static_cast<uint16_t>(signal_column(has_a ? link.node_a : 0, quantity));
  side.column_b = static_cast<uint16_t>(signal_column(has_b ? link.node_b : 0, quantity));
  return side;
}

Effects::Ratio Effects::ratio(Scaled value) {
  if (value.is_zero()) return {};
  const int32_t exponent = log2_floor(value);
  const int32_t shift = 29 - exponent;
  if (shift < 0) return {INT32_MAX, 0};
  if (shift > 62) return {};
  return {static_cast<int32_t>(to_fixed(value, shift)), static_cast<int8_t>(shift)};
}

int64_t Effects::times(Ratio ratio, int64_t x) { return (x * ratio.mantissa) >> ratio.shift; }

int32_t Effects::value(const Side& side, const Frame& frame, int at) {
  const int64_t difference = static_cast<int64_t>(frame.column[side.column_a][at]) * side.gain_a -
                             static_cast<int64_t>(frame.column[side.column_b][at]) * side.gain_b;
  return static_cast<int32_t>(clamp((difference + (int64_t{1} << (kGainShift - 1))) >> kGainShift, kOne));
}

Scaled Effects::unit(const Effect& effect) {
  const int32_t u = effect.elongation.range_exponent, w = effect.rate.range_exponent;
  int32_t exponent = 0;
  switch (effect.kind) {
    case TermKind::kCubicStiffness:
      exponent = 3 * u;
      break;
    case TermKind::kQuadraticStiffness:
      exponent = 2 * u;
      break;
    case TermKind::kBacklash:
    case TermKind::kEndStop:
      exponent = u;
      break;
    case TermKind::kQuadraticDamping:
      exponent = 2 * w;
      break;
    case TermKind::kCubicDamping:
      exponent = 3 * w;
      break;
    case TermKind::kAsymmetricViscous:
      exponent = w;
      break;
    case TermKind::kDisplacementDependentDamping:
      exponent = 2 * u + w;
      break;
    case TermKind::kDriftingViscous:
      exponent = effect.shape.mantissa != 0 ? w : w + kTimeBits;
      break;
    default:
      break;  // gravity, friction shapes and the offset are pure numbers
  }
  return Scaled::from_int(1, exponent - kFraction);
}

void Effects::configure(const CoreConfiguration& configuration, Scaled* column_unit) {
  count_ = 0;
  for (int t = 0; t < configuration.term_count && count_ < kMaxEffectColumns; ++t) {
    const Term& term = configuration.terms[t];
    if (!is_effect_term(term.kind)) continue;
    Effect& effect = effect_[count_];
    effect = Effect{};
    effect.kind = term.kind;
    effect.elongation = side(configuration, configuration.links[term.place], Quantity::kDisplacement);
    effect.rate = side(configuration, configuration.links[term.place], Quantity::kVelocity);
    const Scaled range_u = Scaled::from_int(1, effect.elongation.range_exponent);
    const Scaled range_w = Scaled::from_int(1, effect.rate.range_exponent);
    if (term.kind == TermKind::kGravity) effect.shape = ratio(range_u * turns_per_radian() * Scaled::from_int(64));
    if (term.kind == TermKind::kStribeck && !term.shape.is_zero())
      effect.shape = ratio(log2_e() * range_w / term.shape);
    if (term.kind == TermKind::kPreslidingHysteresis && !term.shape.is_zero())
      effect.shape = ratio(log2_e() * range_u / term.shape);
    // of a drift per sample, in Q26
    if (term.kind == TermKind::kDriftingViscous && !term.shape.is_zero())
      effect.shape = ratio(log2_e() * configuration.sample_period_s / term.shape * Scaled::from_int(1, kFraction));
    effect.gap_q26 = to_fixed(term.shape, kFraction - effect.elongation.range_exponent);
    Scaled column = unit(effect);
    if (term.kind == TermKind::kDriftingViscous)
      column = column * (term.shape.is_zero() ? configuration.sample_period_s : term.shape);
    column_unit[kEffectColumn + count_++] = column;
  }
}

void Effects::restart() {
  for (int e = 0; e < count_; ++e) {
    effect_[e].memory_q26 = 0;
    effect_[e].time = 0;
  }
}

int32_t Effects::force(const Effect& effect, const Frame& frame, int at, uint32_t time) {
  const int64_t u = value(effect.elongation, frame, at), w = value(effect.rate, frame, at);
  switch (effect.kind) {
    // Q26 elongation times turns: 64 U / 2 pi in Q26 is 2^-32 of a turn per step.
    case TermKind::kGravity:
      return sine_of_turns(static_cast<uint32_t>(times(effect.shape, u))).raw >> (30 - kFraction);
    case TermKind::kCubicStiffness:
      return static_cast<int32_t>(product(product(u, u), u));
    case TermKind::kQuadraticStiffness:
      return static_cast<int32_t>(product(u, u));
    case TermKind::kBacklash:
      return static_cast<int32_t>(-clamp(u, effect.gap_q26));
    case TermKind::kEndStop:
      return static_cast<int32_t>(u - clamp(u, effect.gap_q26));
    case TermKind::kQuadraticDamping:
      return static_cast<int32_t>(product(magnitude(w), w));
    case TermKind::kCubicDamping:
      return static_cast<int32_t>(product(product(w, w), w));
    case TermKind::kStribeck:
      return static_cast<int32_t>(sign(w) * exponential_q26(times(effect.shape, magnitude(w))));
    case TermKind::kForceOffset:
      return static_cast<int32_t>(kOne);
    case TermKind::kAsymmetricViscous:
      return static_cast<int32_t>(magnitude(w));
    case TermKind::kDisplacementDependentDamping:
      return static_cast<int32_t>(product(product(u, u), w));
    case TermKind::kDriftingViscous: {
      if (effect.shape.mantissa != 0)  // tau (1 - exp(-t / tau)), in units of tau
        return static_cast<int32_t>(product(w, kOne - exponential_q26(times(effect.shape, time))));
      const int64_t limited = time < (1u << kTimeBits) ? time : (1 << kTimeBits);
      return static_cast<int32_t>((w * limited) >> kTimeBits);
    }
    default:
      return 0;
  }
}

// Dahl's model per unit level: dz = (1 - z sgn(du)) |du| / length, solved exactly over each sample's step of the elongation.
void Effects::fill_hysteresis(Effect& effect, const Frame& frame, int from, int to, int advance, int32_t* column) {
  int64_t z = effect.memory_q26;
  int32_t previous = value(effect.elongation, frame, from);
  for (int at = from; at < to; ++at) {
    const int32_t u = value(effect.elongation, frame, at);
    const int64_t step = static_cast<int64_t>(u) - previous;
    previous = u;
    const int64_t towards = sign(step) * kOne;
    if (step != 0) z = towards + product(z - towards, exponential_q26(times(effect.shape, magnitude(step))));
    column[at] = static_cast<int32_t>(z);
    if (at == from + advance) effect.memory_q26 = static_cast<int32_t>(z);
  }
}

void Effects::fill(Frame& frame, int from, int to, int advance) {
  for (int e = 0; e < count_; ++e) {
    Effect& effect = effect_[e];
    int32_t* column = frame.column[kEffectColumn + e];
    if (effect.kind == TermKind::kPreslidingHysteresis) {
      fill_hysteresis(effect, frame, from, to, advance, column);
    } else {
      for (int at = from; at < to; ++at)
        column[at] = force(effect, frame, at, effect.time + static_cast<uint32_t>(at - from));
    }
    effect.time += static_cast<uint32_t>(advance);
  }
}

}  // namespace firmware

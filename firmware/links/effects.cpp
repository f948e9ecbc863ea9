#include "firmware/links/effects.hpp"

namespace firmware {
namespace {

// log2(e) and 1 / (2 pi), from their continued fractions: error below 1e-12.
Scaled log2_e() { return Scaled::ratio(1865452, 1293033); }
Scaled turns_per_radian() { return Scaled::ratio(265381, 1667438); }

LawRatio law_ratio(const Scaled& value) {
  if (value.is_zero()) return {};
  const int32_t exponent = log2_floor(value);
  const int32_t shift = 29 - exponent;
  if (shift < 0) return {INT32_MAX, 0};
  if (shift > 62) return {};
  return {static_cast<int32_t>(to_fixed(value, shift)), static_cast<int8_t>(shift)};
}

LawShape law_shape(const Term& term, ShapeUse use, int32_t exponent_u, int32_t exponent_w,
                   const Scaled& sample_period_s) {
  const Scaled range_u = power_of_two(exponent_u), range_w = power_of_two(exponent_w);
  LawShape shape;
  if (use == ShapeUse::kGap) shape.gap = LawNumber::from_raw(to_fixed(term.shape, kLawFraction - exponent_u));
  if (use == ShapeUse::kTurns) {
    const Scaled turns = term.shape.is_zero() ? range_u * turns_per_radian() : range_u / term.shape;
    shape.ratio = law_ratio(turns * 64);  // of 2^-26 of the range, in 2^-32 turns
    shape.phase = static_cast<uint32_t>(to_fixed(Scaled::from_int(term.second_shape_q26, 6) * turns_per_radian(), 0));
  }
  if (term.shape.is_zero()) return shape;
  const bool of_rate = use == ShapeUse::kDecayOfRate, of_time = use == ShapeUse::kDecayOfTime;
  if (!of_rate && !of_time && use != ShapeUse::kDecayOfElongation) return shape;
  const Scaled step = of_time ? scale_by_power_of_two(sample_period_s, kLawFraction) : of_rate ? range_w : range_u;
  shape.ratio = law_ratio(log2_e() * step / term.shape);
  return shape;
}

// The unit of a column. Time counts in units of the shape where it levels off, else in samples.
Scaled law_unit(const Term& term, const CoreLaw& law, int32_t exponent_u, int32_t exponent_w,
                const Scaled& sample_period_s) {
  const Scaled unit = power_of_two(law.u_power * exponent_u + law.w_power * exponent_w - kLawFraction);
  if (law.use != ShapeUse::kDecayOfTime) return unit;
  return unit * (term.shape.is_zero() ? power_of_two(kLawTimeBits) * sample_period_s : term.shape);
}

NodeCode code_of(const CoreConfiguration& configuration, uint8_t node, Quantity quantity) {
  if (node == kGroundNode) return {};
  return {signal_column(node, quantity), configuration.signals[node][static_cast<int>(quantity)].unit_per_code,
          full_scale_bits(configuration, node, quantity, kLeastCodeBits)};
}

NodeDifference side(const CoreConfiguration& configuration, const LinkConfiguration& link, Quantity quantity) {
  return node_difference(code_of(configuration, link.node_a, quantity), code_of(configuration, link.node_b, quantity));
}

// A drift that does not level off has no room for more, one that does cannot count further.
uint32_t longest_time(const LawShape& shape) { return shape.ratio.mantissa == 0 ? 1u << kLawTimeBits : UINT32_MAX; }

LawNumber value(const NodeDifference& side, const Frame& frame, int at) {
  return LawNumber::from_raw(difference_at(side, frame.raw[side.column_a], frame.raw[side.column_b], at));
}

}  // namespace

void Effects::configure(const CoreConfiguration& configuration, Scaled* column_unit) {
  count_ = 0;
  complete_ = true;
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    if (!is_effect_term(term.kind)) continue;
    complete_ = count_ < kMaxEffectColumns;
    if (!complete_) return;
    const CoreLaw& law = core_law(term.kind);
    Effect& effect = effect_[count_];
    effect = Effect{};
    effect.kind = term.kind;
    effect.elongation = side(configuration, configuration.links[term.place], Quantity::kDisplacement);
    effect.rate = side(configuration, configuration.links[term.place], Quantity::kVelocity);
    const int32_t u = effect.elongation.range_exponent, w = effect.rate.range_exponent;
    effect.shape = law_shape(term, law.use, u, w, configuration.sample_period_s);
    column_unit[kEffectColumn + count_++] = law_unit(term, law, u, w, configuration.sample_period_s);
  }
}

void Effects::restart(uint32_t time) {
  time_is_out_ = false;
  for (int e = 0; e < count_; ++e) {
    effect_[e].memory = LawForce{};
    effect_[e].moved = false;
    effect_[e].time = time;
  }
}

// A link that moves when its level starts has slid before: its bristles are bent all the way in the direction of its rate.
void Effects::fill_bristles(Effect& effect, const Frame& frame, int from, int to, int advance,
                            Column<LawForce> column) {
  LawNumber z = rescale<LawNumber>(effect.memory);
  if (!effect.moved) {
    z = sign_of(value(effect.rate, frame, from)) * kLawOne;
    effect.moved = true;
  }
  LawNumber previous = value(effect.elongation, frame, from);
  for (int at = from; at < to; ++at) {
    const LawNumber u = value(effect.elongation, frame, at);
    z = bent_bristles(z, u - previous, effect.shape);
    previous = u;
    column.put(at, rescale<LawForce>(z));
    if (at == from + advance) effect.memory = rescale<LawForce>(z);
  }
}

void Effects::fill(Frame& frame, int from, int to, int advance) {
  for (int e = 0; e < count_; ++e) {
    Effect& effect = effect_[e];
    const CoreLaw& law = core_law(effect.kind);
    Column<LawForce> column = frame.effect(e);
    if (law.force == nullptr) {
      fill_bristles(effect, frame, from, to, advance, column);
    } else {
      for (int at = from; at < to; ++at)
        column.put(at, law.force({value(effect.elongation, frame, at), value(effect.rate, frame, at),
                                  effect.time + static_cast<uint32_t>(at - from)},
                                 effect.shape));
    }
    const bool drifts = law.use == ShapeUse::kDecayOfTime;
    if (drifts && longest_time(effect.shape) - static_cast<uint32_t>(to - from) < effect.time) time_is_out_ = true;
    effect.time += static_cast<uint32_t>(advance);
  }
}

}  // namespace firmware

#include "firmware/warrant/block_motion.hpp"

#include "firmware/energy/equation_plan.hpp"

namespace firmware {
namespace {

constexpr int kFraction = 26, kGainShift = 25, kSignFraction = 20, kKnownFraction = 27;
constexpr int kSignalBits = 23, kDerivedBits = 27;
constexpr int32_t kOne = 1 << kFraction;

int32_t clamp(int64_t value, int32_t limit) {
  return static_cast<int32_t>(value > limit ? limit : (value < -limit ? -limit : value));
}
int32_t rounded(int64_t value, int shift) { return clamp((value + (int64_t{1} << (shift - 1))) >> shift, kOne); }
// Quadratic least squares through the four neighbours on either side, at the middle: (54, 39, 14, -21) / 172. In Q3.
int64_t between_neighbours_q3(const int32_t* x) {
  const int64_t sum = 54 * (int64_t{x[-1]} + x[1]) + 39 * (int64_t{x[-2]} + x[2]) + 14 * (int64_t{x[-3]} + x[3]) -
                      21 * (int64_t{x[-4]} + x[4]);
  return (sum * 195084) >> 22;  // 8 / 172
}
// Slope of the same fit: (1, 2, 3, 4) / 60 of the differences. In Q3.
int64_t neighbours_slope_q3(const int32_t* x) {
  const int64_t sum =
      (int64_t{x[1]} - x[-1]) + 2 * (int64_t{x[2]} - x[-2]) + 3 * (int64_t{x[3]} - x[-3]) + 4 * (int64_t{x[4]} - x[-4]);
  return (sum * 559241) >> 22;  // 8 / 60
}

}  // namespace

Difference BlockMotion::difference(Quantity quantity, int node_a, int node_b) const {
  Difference d;
  const bool has_a = node_a != kGroundNode, has_b = node_b != kGroundNode;
  const int row_a = signal_column(has_a ? node_a : 0, quantity), row_b = signal_column(has_b ? node_b : 0, quantity);
  const Scaled unit_a = has_a ? signal_unit_[row_a] : Scaled{}, unit_b = has_b ? signal_unit_[row_b] : Scaled{};
  const Scaled sum = unit_a + unit_b;
  if (sum.is_zero()) return d;
  const bool derived =
      quantity == Quantity::kAcceleration && has_a && node_a < kMaxDofs && derives_acceleration_[node_a];
  d.range_exponent = log2_floor(sum) + 1 + (derived ? kDerivedBits : kSignalBits);
  const int bits = kFraction + kGainShift - d.range_exponent;
  d.gain_a = static_cast<int32_t>(to_fixed(unit_a, bits));
  d.gain_b = static_cast<int32_t>(to_fixed(unit_b, bits));
  d.row_a = static_cast<uint16_t>(row_a);
  d.row_b = static_cast<uint16_t>(row_b);
  return d;
}

void BlockMotion::configure(const CoreConfiguration& configuration, const Scaled* effect_unit) {
  configuration_ = &configuration;
  for (int node = 0; node < kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q)
      signal_unit_[node * kQuantities + q] =
          configuration.signals[node][q].available ? configuration.signals[node][q].unit_per_code : Scaled{};
  for (auto& unit : unit_) unit = Scaled{};
  shares_ = effects_ = 0;
  for (int i = 0; i < configuration.dof_count; ++i) {
    const int row = signal_column(i, Quantity::kAcceleration);
    derives_acceleration_[i] = signal_unit_[row].is_zero();
    if (derives_acceleration_[i])  // eight points, times 840, shifted by 7
      signal_unit_[row] = signal_unit_[signal_column(i, Quantity::kVelocity)] * Scaled::from_int(128) /
                          (Scaled::from_int(840) * configuration.sample_period_s);
    acceleration_[i] = difference(Quantity::kAcceleration, i, kGroundNode);
    unit_[kAccelerationColumn + i] = Scaled::from_int(1, acceleration_[i].range_exponent - kFraction);
    has_force_[i] = configuration.signals[i][0].available;
    if (has_force_[i]) force_[i] = difference(Quantity::kForce, i, kGroundNode);
  }
  for (int l = 0; l < configuration.link_count; ++l) {
    const LinkConfiguration& link = configuration.links[l];
    elongation_[l] = difference(Quantity::kDisplacement, link.node_a, link.node_b);
    rate_[l] = difference(Quantity::kVelocity, link.node_a, link.node_b);
    has_elongation_[l] = elongation_[l].gain_a != 0 || elongation_[l].gain_b != 0;
    unit_[kElongationColumn + l] = Scaled::from_int(1, elongation_[l].range_exponent - kFraction);
    unit_[kRateColumn + l] = Scaled::from_int(1, rate_[l].range_exponent - kFraction);
    unit_[kSoftSignColumn + l] = Scaled::from_int(1, -kSignFraction);
  }
  for (int t = 0; t < configuration.term_count; ++t) {
    effect_of_term_[t] = static_cast<uint8_t>(effects_);
    if (!is_effect_term(configuration.terms[t].kind)) continue;
    unit_[kForceLawColumn + effects_] = effect_unit[effects_];
    ++effects_;
  }
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    if (term.unknown >= 0) continue;
    const int column = column_of(term, t);
    if (term.kind == TermKind::kMass) {
      add_share(term.place, column, -term.value);
      continue;
    }
    const LinkConfiguration& link = configuration.links[term.place];
    if (link.node_a < configuration.dof_count) add_share(link.node_a, column, -term.value);
    if (link.node_b < configuration.dof_count) add_share(link.node_b, column, term.value);
  }
  for (int i = 0; i < configuration.dof_count; ++i) scale_known(i);
}

int BlockMotion::column_of(const Term& term, int number) const {
  switch (term.kind) {
    case TermKind::kMass:
      return kAccelerationColumn + term.place;
    case TermKind::kStiffness:
      return kElongationColumn + term.place;
    case TermKind::kViscous:
      return kRateColumn + term.place;
    case TermKind::kCoulomb:
      return kSoftSignColumn + term.place;
    default:
      return kForceLawColumn + effect_of_term_[number];
  }
}

void BlockMotion::add_share(int dof, int column, Scaled coefficient) {
  if (shares_ == kMaxShares) return;
  share_[shares_].dof = static_cast<uint8_t>(dof);
  share_[shares_].column = static_cast<uint8_t>(column);
  share_value_[shares_++] = coefficient;
}

// Full scale of every term at once stays within 2^27 units.
void BlockMotion::scale_known(int dof) {
  Scaled most = has_force_[dof] ? Scaled::from_int(1, force_[dof].range_exponent) : Scaled{};
  for (int s = 0; s < shares_; ++s)
    if (share_[s].dof == dof)
      most = most + abs(share_value_[s]) * unit_[share_[s].column] * Scaled::from_int(1, kFraction + 1);
  if (most.is_zero()) most = Scaled::from_int(1);
  const Scaled unit = Scaled::from_int(1, log2_floor(most) + 1 - kKnownFraction);
  unit_[kKnownColumn + dof] = unit;
  for (int s = 0; s < shares_; ++s) {
    if (share_[s].dof != dof) continue;
    const Scaled ratio = share_value_[s] * unit_[share_[s].column] / unit;
    const int shift = ratio.is_zero() ? 0 : 29 - log2_floor(ratio);
    share_[s].shift = static_cast<int8_t>(shift > 62 ? 0 : (shift < 0 ? 0 : shift));
    share_[s].mantissa = shift > 62 ? 0 : static_cast<int32_t>(to_fixed(ratio, share_[s].shift));
  }
}

int BlockMotion::append(const Frame& frame, int from, int count) {
  int taken = count - from;
  if (taken > kProbeSamples - filled_) taken = kProbeSamples - filled_;
  const auto copy = [&](const int32_t* source, int32_t* target) {
    for (int i = 0; i < taken; ++i) target[filled_ + i] = source[kLeadIn + from + i];
  };
  for (int node = 0; node < kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q)
      if (configuration_->signals[node][q].available)
        copy(frame.column[node * kQuantities + q], signal_[node * kQuantities + q]);
  for (int e = 0; e < effects_; ++e) copy(frame.column[kEffectColumn + e], force_law_[e]);
  filled_ += taken;
  return taken;
}

void BlockMotion::keep_tail() {
  constexpr int kKept = 2 * kProbeLead;
  const auto move = [](int32_t* row) {
    for (int i = 0; i < kKept; ++i) row[i] = row[kProbeSamples - kKept + i];
  };
  for (auto& row : signal_) move(row);
  for (int e = 0; e < effects_; ++e) move(force_law_[e]);
  filled_ = kKept;
}

// dv/dt from eight points, within the block.
void BlockMotion::fill_acceleration(int dof) {
  const int32_t* v = signal_[signal_column(dof, Quantity::kVelocity)];
  int32_t* a = signal_[signal_column(dof, Quantity::kAcceleration)];
  for (int i = 0; i < kProbeSamples; ++i) {
    if (i < kProbeLead || i + kProbeLead >= kProbeSamples) {
      a[i] = 0;
      continue;
    }
    const int64_t sum = 672 * (int64_t{v[i + 1]} - v[i - 1]) - 168 * (int64_t{v[i + 2]} - v[i - 2]) +
                        32 * (int64_t{v[i + 3]} - v[i - 3]) - 3 * (int64_t{v[i + 4]} - v[i - 4]);
    a[i] = static_cast<int32_t>((sum + 64) >> 7);
  }
}

int32_t BlockMotion::own(const Difference& d, const int32_t* a, const int32_t* b, int at) {
  return rounded(int64_t{a[at]} * d.gain_a - int64_t{b[at]} * d.gain_b, kGainShift);
}
int32_t BlockMotion::smoothed(const Difference& d, const int32_t* a, const int32_t* b, int at) {
  const int64_t left = d.gain_a != 0 ? between_neighbours_q3(a + at) * d.gain_a : 0;
  const int64_t right = d.gain_b != 0 ? between_neighbours_q3(b + at) * d.gain_b : 0;
  return rounded(left - right, kGainShift + 3);
}
int32_t BlockMotion::slope(const Difference& d, const int32_t* a, int at) {
  return rounded(neighbours_slope_q3(a + at) * d.gain_a, kGainShift + 3);
}

void BlockMotion::fill_columns() {
  for (int i = 0; i < configuration_->dof_count; ++i)
    if (derives_acceleration_[i]) fill_acceleration(i);
  for (int e = 0; e < effects_; ++e)
    for (int n = 0; n < kBlockSamples; ++n) column_[kForceLawColumn + e][n] = force_law_[e][kProbeLead + n];
  for (int i = 0; i < configuration_->dof_count; ++i) {
    const int32_t* a = signal(acceleration_[i].row_a);
    for (int n = 0; n < kBlockSamples; ++n) column_[kAccelerationColumn + i][n] = own(acceleration_[i], a, a, n);
  }
  for (int l = 0; l < configuration_->link_count; ++l) {
    const Difference &u = elongation_[l], &w = rate_[l];
    int32_t* rate = column_[kRateColumn + l];
    for (int n = 0; n < kBlockSamples; ++n) rate[n] = own(w, signal(w.row_a), signal(w.row_b), n);
    if (has_elongation_[l])
      for (int n = 0; n < kBlockSamples; ++n)
        column_[kElongationColumn + l][n] = own(u, signal(u.row_a), signal(u.row_b), n);
    const int64_t width = rate_noise_[l] + (rate_noise_[l] >> 2);
    for (int n = 0; n < kBlockSamples; ++n) {
      const int64_t w_q = rate[n];
      const int64_t soft = width > 0 && w_q < width && w_q > -width ? (w_q * (1 << kSignFraction)) / width
                                                                    : ((w_q > 0) - (w_q < 0)) * (1 << kSignFraction);
      column_[kSoftSignColumn + l][n] = static_cast<int32_t>(soft);
    }
  }
  for (int i = 0; i < configuration_->dof_count; ++i) {
    int64_t known[kBlockSamples] = {};
    if (has_force_[i]) {
      const int shift = log2_floor(unit_[kKnownColumn + i]) - (force_[i].range_exponent - kFraction);
      const int32_t* f = signal(force_[i].row_a);
      for (int n = 0; n < kBlockSamples; ++n) {
        const int32_t value = own(force_[i], f, f, n);
        known[n] = shift > 0 ? (value + (1 << (shift - 1))) >> shift : int64_t{value} * (1 << -shift);
      }
    }
    for (int s = 0; s < shares_; ++s) {
      if (share_[s].dof != i) continue;
      const int32_t* column = column_[share_[s].column];
      for (int n = 0; n < kBlockSamples; ++n) known[n] += (int64_t{column[n]} * share_[s].mantissa) >> share_[s].shift;
    }
    for (int n = 0; n < kBlockSamples; ++n) column_[kKnownColumn + i][n] = clamp(known[n], 1 << kKnownFraction);
  }
}

}  // namespace firmware

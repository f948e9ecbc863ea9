#include "firmware/warrant/motion/block_motion.hpp"

#include "firmware/energy/equation_plan.hpp"
#include "firmware/fixed_point/magnitude.hpp"
#include "firmware/fixed_point/wider_vectors.hpp"

namespace firmware {
namespace {

constexpr int kSignFraction = PassedSign::kFractionBits;
constexpr int kSignalBits = 23, kDerivedBits = 27;
constexpr int kSlopeRestShift = 10;     // room for a channel whose unit is 1000 times another
constexpr int kSlopeMantissaBits = 26;  // times 24 bits of code and 11 of the eight points: 61

}  // namespace

bool measures_slope(const CoreConfiguration& configuration, Slope slope, int dof) {
  if (kDerivesSignals && (configuration.high_pass_order > 0 || configuration.fuses(dof))) return false;
  const SignalConfiguration* const flat =
      &configuration.signals[dof][static_cast<int>(Quantity::kDisplacement) + static_cast<int>(slope)];
  return flat[0].available && flat[1].available && !flat[0].is_derived() && !flat[1].is_derived();
}

NodeDifference BlockMotion::difference(Quantity quantity, int node_a, int node_b) const {
  const bool derived = quantity == Quantity::kAcceleration && node_a < kMaxDofs && derives_acceleration_[node_a];
  const auto code_of = [&](int node) {
    if (node == kGroundNode) return NodeCode{};
    const int row = signal_column(node, quantity);
    return NodeCode{row, signal_unit_[row], derived ? kDerivedBits : kSignalBits};
  };
  return node_difference(code_of(node_a), code_of(node_b));
}

void BlockMotion::configure(const CoreConfiguration& configuration, const Scaled* effect_unit,
                            const ClearSigns& signs) {
  configuration_ = &configuration;
  signs_ = signs;
  for (int node = 0; node < kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q)
      signal_unit_[node * kQuantities + q] =
          configuration.signals[node][q].available ? configuration.signals[node][q].unit_per_code : Scaled{};
  for (auto& unit : unit_) unit = Scaled{};
  const auto unit_of = [](const NodeDifference& d) { return power_of_two(d.range_exponent - kDifferenceFraction); };
  for (int i = 0; i < configuration.dof_count; ++i) {
    const int row = signal_column(i, Quantity::kAcceleration);
    derives_acceleration_[i] = signal_unit_[row].is_zero();
    if (derives_acceleration_[i])  // slope_840(), shifted
      signal_unit_[row] = signal_unit_[signal_column(i, Quantity::kVelocity)] * (1 << kSlopeShift) /
                          (Scaled::from_int(840) * configuration.sample_period_s);
    acceleration_[i] = difference(Quantity::kAcceleration, i, kGroundNode);
    unit_[kAccelerationColumn + i] = unit_of(acceleration_[i]);
    force_[i] = difference(Quantity::kForce, i, kGroundNode);
  }
  for (int l = 0; l < configuration.link_count; ++l) {
    const LinkConfiguration& link = configuration.links[l];
    elongation_[l] = difference(Quantity::kDisplacement, link.node_a, link.node_b);
    rate_[l] = difference(Quantity::kVelocity, link.node_a, link.node_b);
    unit_[kElongationColumn + l] = unit_of(elongation_[l]);
    unit_[kRateColumn + l] = unit_of(rate_[l]);
    unit_[kSoftSignColumn + l] = power_of_two(-kSignFraction);
  }
  for (int i = 0; i < configuration.dof_count; ++i) {
    configure_slope(Slope::kOfDisplacement, i);
    configure_slope(Slope::kOfVelocity, i);
  }
  configure_effects(effect_unit);
  share_known_terms();
}

void BlockMotion::configure_slope(Slope slope, int dof) {
  SlopeUnit& unit = slope_[static_cast<int>(slope)][dof] = SlopeUnit{};
  if (!measures_slope(*configuration_, slope, dof)) return;
  const bool of_velocity = slope == Slope::kOfVelocity;
  unit.steeper = difference(of_velocity ? Quantity::kAcceleration : Quantity::kVelocity, dof, kGroundNode);
  Scaled& column_unit = unit_[slope_rest_column(slope, dof)];
  column_unit = power_of_two(unit.steeper.range_exponent - kDifferenceFraction + kSlopeRestShift);
  const int row = signal_column(dof, of_velocity ? Quantity::kVelocity : Quantity::kDisplacement);
  const Scaled ratio = signal_unit_[row] / (Scaled::from_int(840) * configuration_->sample_period_s * column_unit);
  const int shift = kSlopeMantissaBits - 1 - log2_floor(ratio);
  if (shift < 1 || shift > 62) return;  // units of no use: not compared
  unit.shift = static_cast<int8_t>(shift);
  unit.mantissa = static_cast<int32_t>(to_fixed(ratio, shift));
}

void BlockMotion::configure_effects(const Scaled* effect_unit) {
  effects_ = 0;
  for (int t = 0; t < configuration_->term_count; ++t) {
    effect_of_term_[t] = static_cast<uint8_t>(effects_);
    if (!is_effect_term(configuration_->terms[t].kind) || effects_ == kMaxEffectColumns) continue;
    unit_[kForceLawColumn + effects_] = effect_unit[effects_];
    ++effects_;
  }
}

void BlockMotion::share_known_terms() {
  known_.clear();
  for (int t = 0; t < configuration_->term_count; ++t) {
    const Term& term = configuration_->terms[t];
    if (term.unknown >= 0) continue;
    const int column = column_of(term, t);
    if (term.kind == TermKind::kMass) {
      known_.add(term.place, column, -term.value);
      continue;
    }
    const LinkConfiguration& link = configuration_->links[term.place];
    if (link.node_a < configuration_->dof_count) known_.add(link.node_a, column, -term.value);
    if (link.node_b < configuration_->dof_count) known_.add(link.node_b, column, term.value);
  }
  for (int i = 0; i < configuration_->dof_count; ++i)
    unit_[kKnownColumn + i] = known_.scale(i, unit_, force_[i].present(), force_[i].range_exponent);
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

int BlockMotion::append(const Frame& frame, int from, int count) {
  int taken = count - from;
  if (taken > kProbeSamples - filled_) taken = kProbeSamples - filled_;
  const auto copy = [&](const int32_t* source, int32_t* target) {
    for (int i = 0; i < taken; ++i) target[filled_ + i] = source[kLeadIn + from + i];
  };
  for (int node = 0; node < kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q)
      if (configuration_->signals[node][q].available)
        copy(frame.raw[node * kQuantities + q], signal_[node * kQuantities + q]);
  for (int e = 0; e < effects_; ++e) copy(frame.raw[kEffectColumn + e], force_law_[e]);
  for (int l = 0; l < configuration_->link_count; ++l)
    if (signs_.link[l]) copy(frame.raw[kClearSignColumn + l], clear_sign_[l]);
  for (int i = 0; i < configuration_->dof_count; ++i)
    if (signs_.dof[i]) copy(frame.raw[kClearInstrumentColumn + i], counted_[i]);
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
  for (auto& row : clear_sign_) move(row);
  for (auto& row : counted_) move(row);
  filled_ = kKept;
}

int32_t BlockMotion::smoothed_at(const NodeDifference& d, int n) const {
  return smoothed(d, near_[d.column_a][n], near_[d.column_b][n]);
}

// dv/dt from eight points, within the block, and its instrument.
void BlockMotion::fill_acceleration(int dof) {
  const int row = signal_column(dof, Quantity::kAcceleration);
  const int32_t* v = signal(signal_column(dof, Quantity::kVelocity));
  int32_t* a = signal_[row];
  for (int i = 0; i < kProbeLead; ++i) a[i] = a[kProbeSamples - 1 - i] = 0;
  for (int n = 0; n < kBlockSamples; ++n) {
    a[kProbeLead + n] = static_cast<int32_t>((slope_840(v + n) + (1 << (kSlopeShift - 1))) >> kSlopeShift);
    near_[row][n] = orthogonal_slope_q3(v + n);
  }
}

FIRMWARE_WIDEST_VECTORS void BlockMotion::fill_neighbours() {
  for (int row = 0; row < kMaxNodes * kQuantities; ++row) {
    if (signal_unit_[row].is_zero()) continue;
    const int node = row / kQuantities;
    if (node < kMaxDofs && derives_acceleration_[node] && row == signal_column(node, Quantity::kAcceleration)) {
      fill_acceleration(node);
      continue;
    }
    const int32_t* of = signal(row);
    for (int n = 0; n < kBlockSamples; ++n) near_[row][n] = between_neighbours_q3(of + n);
  }
}

// The friction's direction is not that of the sample before or after.
bool BlockMotion::turns(int link, int sample) const {
  const int32_t* sign = clear_sign_[link] + kProbeLead + sample;
  return (sign[-1] > 0) != (sign[0] > 0) || (sign[1] > 0) != (sign[0] > 0);
}

// Electronics and an anti-alias filter smear friction's jump in the acceleration over the samples beside it, which looks like a
// Stribeck force. Signs that have passed a filter with their equation jump as it does. Whether the samples beside are clear is not
// asked: that hangs on the sample's own noise, which would choose what is tested.
void BlockMotion::fill_settled() {
  for (int i = 0; i < configuration_->dof_count; ++i) {
    if (!signs_.dof[i]) continue;
    const int32_t* counted = counted_[i] + kProbeLead;
    for (int n = 0; n < kBlockSamples; ++n) settled_[i][n] = counted[n] != 0;
  }
  for (int l = 0; l < configuration_->link_count && !signs_.filtered; ++l) {
    if (!signs_.link[l]) continue;
    const int nodes[] = {configuration_->links[l].node_a, configuration_->links[l].node_b};
    for (const int i : nodes) {
      if (i >= configuration_->dof_count || !signs_.dof[i]) continue;
      for (int n = 0; n < kBlockSamples; ++n)
        if (turns(l, n)) settled_[i][n] = false;
    }
  }
}

void BlockMotion::fill_link(int l) {
  const NodeDifference &u = elongation_[l], &w = rate_[l];
  for (int n = 0; n < kBlockSamples; ++n)
    column_[kRateColumn + l][n] = difference_at(w, signal(w.column_a), signal(w.column_b), n);
  if (u.present())
    for (int n = 0; n < kBlockSamples; ++n)
      column_[kElongationColumn + l][n] = difference_at(u, signal(u.column_a), signal(u.column_b), n);
  if (!signs_.link[l]) return fill_soft_sign(l);
  for (int n = 0; n < kBlockSamples; ++n)
    column_[kSoftSignColumn + l][n] =
        clear_sign_[l][kProbeLead + n] * (kDerivesSignals && signs_.filtered ? 1 : 1 << kSignFraction);
}

void BlockMotion::fill_soft_sign(int l) {
  const int64_t noise = rate_noise_[l], width = noise + (noise >> 2);
  for (int n = 0; n < kBlockSamples; ++n) {
    const int64_t w = column_[kRateColumn + l][n];
    column_[kSoftSignColumn + l][n] = soft_sign(w, width, kSignFraction);
  }
}

void BlockMotion::fill_known(int i) {
  int64_t known[kBlockSamples] = {};
  if (force_[i].present()) {
    constexpr int kNothingLeft = kDifferenceFraction + 2;  // of any force
    int shift = log2_floor(unit_[kKnownColumn + i]) - (force_[i].range_exponent - kDifferenceFraction);
    if (shift > kNothingLeft) shift = kNothingLeft;
    const int32_t* f = signal(force_[i].column_a);
    for (int n = 0; n < kBlockSamples; ++n) {
      const int32_t value = difference_at(force_[i], f, f, n);
      known[n] = shift > 0 ? (value + (1 << (shift - 1))) >> shift : int64_t{value} * (1 << -shift);
    }
  }
  known_.add_to(i, column_, known);
  constexpr int64_t kMost = int64_t{1} << kKnownFraction;
  for (int n = 0; n < kBlockSamples; ++n)
    column_[kKnownColumn + i][n] =
        static_cast<int32_t>(known[n] > kMost ? kMost : (known[n] < -kMost ? -kMost : known[n]));
}

void BlockMotion::fill_slope_rest(Slope slope, int dof) {
  const SlopeUnit& unit = slope_[static_cast<int>(slope)][dof];
  if (unit.mantissa == 0) return;
  const int32_t* steeper = signal(unit.steeper.column_a);
  const int32_t* flat = signal(unit.steeper.column_a - 1);  // quantities stand in the order of their slopes
  int32_t* rest = column_[slope_rest_column(slope, dof)];
  constexpr int64_t kMost = int64_t{1} << kKnownFraction;
  for (int n = 0; n < kBlockSamples; ++n) {
    const int64_t of_flat = (slope_840(flat + n) * unit.mantissa) >> unit.shift;
    const int64_t of_steeper = difference_at(unit.steeper, steeper, steeper, n) >> kSlopeRestShift;
    rest[n] = static_cast<int32_t>(limited(of_steeper - of_flat, kMost));
  }
}

FIRMWARE_WIDEST_VECTORS void BlockMotion::fill_columns() {
  fill_settled();
  for (int e = 0; e < effects_; ++e)
    for (int n = 0; n < kBlockSamples; ++n) column_[kForceLawColumn + e][n] = force_law_[e][kProbeLead + n];
  for (int i = 0; i < configuration_->dof_count; ++i) {
    const int32_t* a = signal(acceleration_[i].column_a);
    for (int n = 0; n < kBlockSamples; ++n)
      column_[kAccelerationColumn + i][n] = difference_at(acceleration_[i], a, a, n);
  }
  for (int l = 0; l < configuration_->link_count; ++l) fill_link(l);
  for (int i = 0; i < configuration_->dof_count; ++i) fill_known(i);
  for (int i = 0; i < configuration_->dof_count; ++i) {
    fill_slope_rest(Slope::kOfDisplacement, i);
    fill_slope_rest(Slope::kOfVelocity, i);
  }
}

}  // namespace firmware

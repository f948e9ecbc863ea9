#include "firmware/warrant/verdict/channel_correction.hpp"

#include "firmware/identification/conditions/skew.hpp"

#if FIRMWARE_WARRANT_NUMBERS > 0

namespace firmware {
namespace {

constexpr int kWellMeasured = 20;  // deviations: a twentieth of what it bends is left
constexpr int kMostPeriods = 3;    // what channel_shift reaches
constexpr int kMostGainPart = 5;   // a gain of more than a fifth is a slip for a person to look at
constexpr int kAgreeing = 4;       // deviations, of two channels

// Displacement, velocity and acceleration are there, each a sensor's own.
bool three_channels(const CoreConfiguration& configuration, int dof) {
  static_assert(static_cast<int>(Quantity::kForce) == 0 && kQuantities == 4,
                "the motion's three come behind the force");
  for (int q = 1; q < kQuantities; ++q)
    if (!configuration.channels[dof][q].present || configuration.signals[dof][q].is_derived()) return false;
  return !configuration.fuses(dof);
}

bool any_withdrawn(const Estimates& estimates) {
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const EstimateStatus status = estimates.parameters[k].status;
    if (status == EstimateStatus::kSkewed || status == EstimateStatus::kModelSuspect) return true;
  }
  return false;
}

// Two of the three agree in time: a velocity that is early has both its neighbours late alike.
bool one_is_late(const Estimates& estimates, const Finding& late) {
  const SkewEstimate &x = estimates.displacement_skew[late.node_a], &a = estimates.acceleration_skew[late.node_a];
  if (!x.measured || !a.measured) return false;
  const bool of_velocity = late.quantity == static_cast<uint8_t>(Quantity::kVelocity);
  const bool of_acceleration = late.quantity == static_cast<uint8_t>(Quantity::kAcceleration);
  const Scaled off = of_velocity ? x.late_s - a.late_s : of_acceleration ? x.late_s : a.late_s;
  const Scaled std = of_velocity ? root_of_squares(x.std_s, a.std_s) : of_acceleration ? x.std_s : a.std_s;
  return exceeds(std * kAgreeing, off) || exceeds(late.size, times(off, 10));
}

}  // namespace

ChannelCorrections::Correction* ChannelCorrections::of(int node, Quantity quantity) {
  for (int i = 0; i < count_; ++i)
    if (correction_[i].node == node && correction_[i].quantity == quantity) return &correction_[i];
  if (count_ == kMostShifted) return nullptr;
  Correction& added = correction_[count_];
  added = Correction{};
  added.node = static_cast<uint8_t>(node);
  added.quantity = quantity;
  added.gain = kScaledOne;
  return &added;
}

bool ChannelCorrections::take(const CoreConfiguration& configuration, const Estimates& estimates) {
  const Finding& named = estimates.warrant.named;
  const bool delay = named.cause == cause_of(EffectKind::kSensorDelay);
  // A deviation from a few batches is none.
  if (!estimates.warrant.tested || !estimates.warrant.confirmed || !any_withdrawn(estimates)) return false;
  if (!delay && named.cause != cause_of(EffectKind::kSensorGain)) return false;
  if (named.node_a < 0 || named.node_a >= configuration.dof_count || named.quantity >= kQuantities) return false;
  const auto quantity = static_cast<Quantity>(named.quantity);
  if (quantity == Quantity::kForce || !three_channels(configuration, named.node_a)) return false;
  Correction* const correction = of(named.node_a, quantity);
  if (correction == nullptr) return false;
  // Of a channel that is corrected the rest is taken out too where it is found at all: by more samples than the time before.
  const bool again = correction != &correction_[count_];
  if (!again && exceeds(named.std * kWellMeasured, named.size)) return false;
  if (!again && delay && !one_is_late(estimates, named)) return false;
  const Scaled late_s = delay ? correction->late_s + named.size : correction->late_s;
  const Scaled gain = delay ? correction->gain : correction->gain * (kScaledOne + named.size);
  if (exceeds(late_s, times(configuration.sample_period_s, kMostPeriods))) return false;
  if (exceeds(times(gain - kScaledOne, kMostGainPart), kScaledOne)) return false;
  correction->late_s = late_s;
  correction->gain = gain;
  correction->last = named;
  correction->last.size = delay ? late_s : gain - kScaledOne;
  if (!again) ++count_;
  return true;
}

void ChannelCorrections::apply(const CoreConfiguration& configuration, Conditioning& conditioning) const {
  for (int i = 0; i < count_; ++i) {
    const Correction& c = correction_[i];
    conditioning.shift(i, c.node, c.quantity, shift_taps(c.late_s / configuration.sample_period_s, c.gain));
  }
}

// A velocity's delay is one of both its neighbours.
void ChannelCorrections::widen(const CoreConfiguration& configuration, const BatchTable& table,
                               Estimates& estimates) const {
  Skews rest;
  for (int i = 0; i < count_; ++i) {
    if (correction_[i].late_s.is_zero()) continue;
    const int dof = correction_[i].node;
    const SkewEstimate &x = estimates.displacement_skew[dof], &a = estimates.acceleration_skew[dof];
    if (correction_[i].quantity != Quantity::kAcceleration) rest.displacement[dof] = root_of_squares(x.late_s, x.std_s);
    if (correction_[i].quantity != Quantity::kDisplacement) rest.acceleration[dof] = root_of_squares(a.late_s, a.std_s);
  }
  const EquationList list = list_equations(configuration, table);
  for (int k = 0; k < estimates.unknown_count; ++k)
    firmware::widen(estimates.parameters[k], bend_of_skews(list, table, configuration, k, rest, estimates));
}

// A rest that bends nothing is no news.
void ChannelCorrections::tell(Estimates& estimates) const {
  Warrant& warrant = estimates.warrant;
  if (count_ == 0 || !warrant.tested) return;
  const Finding& last = correction_[count_ - 1].last;
  const bool rest = warrant.named.cause == last.cause && warrant.named.node_a == last.node_a &&
                    warrant.named.quantity == last.quantity && !any_withdrawn(estimates);
  if (warrant.named.cause != Cause::kNone && !rest) return;
  firmware::clear(warrant);
  warrant.tested = warrant.corrected = true;
  warrant.named = last;
  warrant.gained = kScaledOne;
}

}  // namespace firmware

#endif

#include "firmware/warrant/verdict/finding.hpp"

#include "firmware/warrant/verdict/channel_fault.hpp"

namespace firmware {
namespace {

// A displacement of another gain shows in the springs beside it too; a velocity does not.
bool gain_shows_in_springs(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                           const ScoreTest& test, int probe) {
  const Place& place = plan.place_of(probe);
  for (int j = plan.base_count; j < plan.summed_count; ++j) {
    const Place& at = plan.place_of(j);
    if (plan.probe[j].form != Form::kElongation || at.kind != PlaceKind::kLink || !test.score(j).flagged) continue;
    if (at.node_a != place.node_a && at.node_b != place.node_a) continue;
    const Scaled stiffness = coefficient_at(configuration, estimates, TermKind::kStiffness, at.link);
    const Scaled least = scale_by_power_of_two(stiffness * test.score(probe).effect, -2);
    if (exceeds(test.score(j).effect, least)) return true;
  }
  return false;
}

// The DOF's other pair of channels: acceleration and velocity beside velocity and displacement. -1: none that tells as small a gain.
int other_pair(const ProbePlan& plan, const ScoreTest& test, int probe) {
  const Place& place = plan.place_of(probe);
  const Scaled gain = abs(test.score(probe).effect);
  for (int j = plan.base_count; j < plan.summed_count; ++j) {
    const Place& at = plan.place_of(j);
    if (j == probe || !compares_channels(at.kind) || at.node_a != place.node_a) continue;
    return test.score(j).tested && scale_by_power_of_two(test.score(j).std, 2) < gain ? j : -1;
  }
  return -1;
}

Scaled up_to_one(const Scaled& gain) {
  const Scaled size = abs(gain);
  return kScaledOne < size ? kScaledOne : size;
}

// Of two channels that contradict each other, steeper and flatter by one derivative, which is off? A velocity contradicts both
// its neighbours. Without a third channel a displacement shows in the springs beside it.
Quantity channel_off(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                     const ScoreTest& test, int probe) {
  const bool of_acceleration = plan.place_of(probe).kind == PlaceKind::kAccelerationChannels;
  const int other = other_pair(plan, test, probe);
  if (other >= 0) {
    const Scaled gain = up_to_one(test.score(probe).effect), beside = up_to_one(test.score(other).effect);
    if (scale_by_power_of_two(beside, 1) > gain) return Quantity::kVelocity;
    return of_acceleration ? Quantity::kAcceleration : Quantity::kDisplacement;
  }
  if (of_acceleration) return Quantity::kAcceleration;
  return gain_shows_in_springs(configuration, estimates, plan, test, probe) ? Quantity::kDisplacement
                                                                            : Quantity::kVelocity;
}

// What holds its value from sample to sample acts half a sample later than what is measured.
bool is_half_a_sample(const CoreConfiguration& configuration, const Scaled& late_s) {
  const Scaled off = abs(scale_by_power_of_two(late_s, 1) + configuration.sample_period_s);
  return off * 100 < configuration.sample_period_s * kSlipPercent;
}

}  // namespace

Finding finding_of(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                   const ScoreTest& test, int probe) {
  Finding finding;
  if (probe < 0) return finding;
  const Probe& p = plan.probe[probe];
  const Place& place = plan.place[p.place];
  finding.cause = p.cause;
  finding.quantity = p.quantity;
  finding.node_a = static_cast<int8_t>(place.node_a);
  if (p.quantity == kNoQuantity && place.kind != PlaceKind::kDof) finding.node_b = static_cast<int8_t>(place.node_b);
  const Scaled unit = fault_unit(configuration, estimates, p, place);
  finding.size = test.score(probe).effect * unit;
  finding.std = test.score(probe).std * abs(unit);
  if (p.form == Form::kForceRate && is_half_a_sample(configuration, finding.size))
    finding.cause = cause_of(EffectKind::kForceHold);
  if (p.cause != cause_of(EffectKind::kSensorGain)) return finding;
  if (compares_channels(place.kind)) {
    const Quantity off = channel_off(configuration, estimates, plan, test, probe);
    finding.quantity = static_cast<uint8_t>(off);
    if (off != static_cast<Quantity>(p.quantity)) {  // the flatter of the two
      finding.size = -finding.size;
      finding.cause = slip_of(kScaledOne + finding.size, finding.cause);
      return finding;
    }
  }
  // The channel says 1 + e times the truth: e / (1 + e) of what it says is not so.
  const Scaled true_share = kScaledOne - finding.size;
  if (true_share.is_zero()) return finding;
  finding.size /= true_share;
  finding.std /= true_share * true_share;
  finding.cause = slip_of(kScaledOne + finding.size, finding.cause);
  return finding;
}

}  // namespace firmware

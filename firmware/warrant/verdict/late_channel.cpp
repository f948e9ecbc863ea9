#include "firmware/warrant/verdict/late_channel.hpp"

#include "firmware/warrant/verdict/channel_fault.hpp"

namespace firmware {
namespace {

constexpr int kMostPeriods = 3;  // a delay of more is none

bool measures_velocity(const CoreConfiguration& configuration, int dof) {
  return !configuration.fuses(dof) && !configuration.signals[dof][static_cast<int>(Quantity::kVelocity)].is_derived();
}

// Of one DOF. A velocity that is early makes displacement and acceleration late alike.
Finding late_channel_of(const CoreConfiguration& configuration, const Estimates& estimates, int dof) {
  const SkewEstimate &x = estimates.displacement_skew[dof], &a = estimates.acceleration_skew[dof];
  Finding finding;
  if (!x.significant && !a.significant) return finding;
  const bool of_acceleration = a.significant && (!x.significant || exceeds(a.late_s, x.late_s));
  const SkewEstimate &late = of_acceleration ? a : x, &other = of_acceleration ? x : a;
  const bool alike = other.measured && measures_velocity(configuration, dof) &&
                     late.late_s.is_negative() == other.late_s.is_negative() &&
                     exceeds(scale_by_power_of_two(other.late_s, 1), late.late_s);
  finding.cause = cause_of(EffectKind::kSensorDelay);
  finding.node_a = static_cast<int8_t>(dof);
  finding.quantity = static_cast<uint8_t>(of_acceleration ? Quantity::kAcceleration : Quantity::kDisplacement);
  finding.size = late.late_s;
  finding.std = late.std_s;
  if (!alike) return finding;
  const SkewEstimate& sure = x.std_s < a.std_s ? x : a;
  finding.quantity = static_cast<uint8_t>(Quantity::kVelocity);
  finding.size = -sure.late_s;
  finding.std = sure.std_s;
  return finding;
}

// What the equation of motion says of an acceleration's delay: effect and deviation, s. False: it says nothing.
bool delay_by_equation(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                       const ScoreTest& test, int dof, Scaled& late_s, Scaled& std_s) {
  for (int j = plan.base_count; j < plan.summed_count; ++j) {
    const Place& at = plan.place_of(j);
    if (plan.probe[j].form != Form::kJerk || at.node_a != dof || !test.score(j).tested) continue;
    const Scaled unit = fault_unit(configuration, estimates, plan.probe[j], at);
    late_s = test.score(j).effect * unit;
    std_s = test.score(j).std * abs(unit);
    return true;
  }
  return false;
}

bool is_acceleration_beside_force(const CoreConfiguration& configuration, const Finding& late) {
  return late.quantity == static_cast<uint8_t>(Quantity::kAcceleration) &&
         configuration.channels[late.node_a][static_cast<int>(Quantity::kForce)].present;
}

// A force that is held from sample to sample makes the acceleration of its DOF jump with every sample: against the velocity it comes
// early, and the equation of motion, where it stands beside that very force, knows nothing of it: what it says is no more than chance, or
// of the other sign. Sampled before the jump it comes late.
void ask_equation(const CoreConfiguration& configuration, const ProbePlan& plan, const ScoreTest& test,
                  Estimates& estimates, Finding& late) {
  if (!is_acceleration_beside_force(configuration, late)) return;
  Scaled by_equation_s, std_s;
  const bool answers = delay_by_equation(configuration, estimates, plan, test, late.node_a, by_equation_s, std_s);
  estimates.warrant.confirmed = answers && exceeds(late.size, scale_by_power_of_two(by_equation_s - late.size, 1));
  const Scaled chance = scale_by_power_of_two(std_s, 2), most = abs(by_equation_s) + chance;
  if (!answers || !late.size.is_negative() || !exceeds(late.size, scale_by_power_of_two(most, 1))) return;
  if (by_equation_s < -chance) return;
  late.cause = cause_of(EffectKind::kForceHold);
  late.quantity = static_cast<uint8_t>(Quantity::kForce);
  late.size = scale_by_power_of_two(-configuration.sample_period_s, -1);
}

// The probe of this form at the DOF, or at one of its links (grounded: to the ground alone), with the largest gain in likelihood;
// -1: none.
int best_at(const ProbePlan& plan, const ScoreTest& test, Form form, int dof, bool grounded = false) {
  int best = -1;
  for (int j = plan.base_count; j < plan.summed_count; ++j) {
    const Place& at = plan.place_of(j);
    const bool beside = at.kind == PlaceKind::kDof    ? at.node_a == dof
                        : at.kind == PlaceKind::kLink ? at.node_a == dof || at.node_b == dof
                                                      : false;
    if (plan.probe[j].form != form || !beside || !test.score(j).tested) continue;
    if (grounded && at.node_b != kGroundNode) continue;
    if (best < 0 || test.score(j).gain > test.score(best).gain) best = j;
  }
  return best;
}

// A velocity made of a displacement and an acceleration lies between the two: in time, so that the one comes late against it where
// the other comes early; and in size, so that a gain of one turns it against both alike.
bool is_gain(const CoreConfiguration& configuration, const Estimates& estimates, int dof) {
  const SkewEstimate &x = estimates.displacement_skew[dof], &a = estimates.acceleration_skew[dof];
  if (!x.significant || !a.significant) return false;
  const Scaled most = times(configuration.sample_period_s, kMostPeriods);
  return x.late_s.is_negative() == a.late_s.is_negative() || exceeds(x.late_s, most) || exceeds(a.late_s, most);
}

// Whose gain: a displacement shows in the springs, an acceleration in the mass. A share e of its force is missing where the channel says
// 1 / (1 + e) of the truth. The velocity is off too, and its damping force with it: that is an eighth of the size. What springs say of it
// their neighbours take up: half of the size, and between two masses no slip.
void tell_gain(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
               const ScoreTest& test, Finding& late) {
  const int dof = late.node_a, spring = best_at(plan, test, Form::kElongation, dof);
  const int grounded = best_at(plan, test, Form::kElongation, dof, true);
  const int inertia = best_at(plan, test, Form::kAcceleration, dof);
  if (spring < 0 && inertia < 0) return;
  const bool of_acceleration = spring < 0 || (inertia >= 0 && test.score(inertia).gain > test.score(spring).gain);
  const int probe = of_acceleration ? inertia : grounded >= 0 ? grounded : spring;
  const ProbeScore& score = test.score(probe);
  const Scaled own = of_acceleration
                         ? coefficient_at(configuration, estimates, TermKind::kMass, dof)
                         : coefficient_at(configuration, estimates, TermKind::kStiffness, plan.place_of(probe).link);
  const Scaled said = own + score.effect;
  if (own.is_zero() || said.is_zero()) return;
  late.quantity = static_cast<uint8_t>(of_acceleration ? Quantity::kAcceleration : Quantity::kDisplacement);
  late.size = -(score.effect / said);
  const Scaled std = score.std * abs(own / (said * said)),
               doubt = scale_by_power_of_two(late.size, of_acceleration ? -3 : -1);
  late.std = root_of_squares(std, doubt);
  late.cause = cause_of(EffectKind::kSensorGain);
  if (of_acceleration || grounded >= 0) late.cause = slip_of(own / said, late.cause, kRoughSlipPercent);
}

// Which of the two is late the acceleration's own equation says: by as much, or not at all.
void tell_delay(const CoreConfiguration& configuration, const Estimates& estimates, const ProbePlan& plan,
                const ScoreTest& test, Finding& late) {
  const SkewEstimate &x = estimates.displacement_skew[late.node_a], &a = estimates.acceleration_skew[late.node_a];
  if (!x.measured || !a.measured) return;
  const Scaled between_s = a.late_s - x.late_s;
  Scaled by_equation_s, std_s;
  const bool of_acceleration =
      delay_by_equation(configuration, estimates, plan, test, late.node_a, by_equation_s, std_s) &&
      exceeds(between_s, scale_by_power_of_two(by_equation_s - between_s, 1));
  late.quantity = static_cast<uint8_t>(of_acceleration ? Quantity::kAcceleration : Quantity::kDisplacement);
  late.size = of_acceleration ? by_equation_s : -between_s;
  late.std = of_acceleration ? std_s : root_of_squares(x.std_s, a.std_s);
}

}  // namespace

bool late_channel(const CoreConfiguration& configuration, const Estimates& estimates, Finding& worst) {
  worst = Finding{};
  for (int dof = 0; dof < configuration.dof_count; ++dof) {
    const Finding finding = late_channel_of(configuration, estimates, dof);
    if (finding.cause != Cause::kNone && exceeds(finding.size, worst.size)) worst = finding;
  }
  return worst.cause != Cause::kNone;
}

void ask_equations(const CoreConfiguration& configuration, const ProbePlan& plan, const ScoreTest& test,
                   Estimates& estimates, Finding& late) {
  if (!configuration.fuses(late.node_a)) return ask_equation(configuration, plan, test, estimates, late);
  if (is_gain(configuration, estimates, late.node_a)) return tell_gain(configuration, estimates, plan, test, late);
  tell_delay(configuration, estimates, plan, test, late);
}

}  // namespace firmware

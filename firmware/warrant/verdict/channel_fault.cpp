#include "firmware/warrant/verdict/channel_fault.hpp"

namespace firmware {

Scaled coefficient_at(const CoreConfiguration& configuration, const Estimates& estimates, TermKind kind, int place) {
  for (int t = 0; t < configuration.term_count; ++t) {
    const Term& term = configuration.terms[t];
    if (term.kind != kind || term.place != place) continue;
    return term.unknown < 0 ? term.value : estimates.parameters[term.unknown].value;
  }
  return {};
}

Scaled fault_unit(const CoreConfiguration& configuration, const Estimates& estimates, const Probe& probe,
                  const Place& place) {
  const auto per = [](const Scaled& a, const Scaled& b) { return b.is_zero() ? Scaled{} : a / b; };
  const Scaled mass = coefficient_at(configuration, estimates, TermKind::kMass, place.node_a);
  const Scaled stiffness = coefficient_at(configuration, estimates, TermKind::kStiffness, place.link);
  if (place.kind == PlaceKind::kBaseEnd) return per(Scaled::from_int(probe.form == Form::kRate ? 1 : -1), stiffness);
  if (probe.form == Form::kJerk) return per(configuration.sample_period_s, mass);
  if (probe.form == Form::kForceRate) return -configuration.sample_period_s;
  return kScaledOne;
}

Cause slip_of(const Scaled& gain, Cause otherwise, int percent) {
  const auto near = [&](const Scaled& value, int within) { return exceeds(value * within, (gain - value) * 100); };
  const Scaled gravity = Scaled::ratio(980665, 100000), thousand = Scaled::from_int(1000);
  if (near(Scaled::from_int(-1), percent)) return Cause::kPolarity;
  const bool large = near(gravity, percent) || near(thousand, percent);
  // A thousandth stands beside noise.
  const bool small = near(kScaledOne / gravity, percent) || near(kScaledOne / thousand, kRoughSlipPercent);
  return large || small ? Cause::kUnit : otherwise;
}

}  // namespace firmware

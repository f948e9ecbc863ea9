// What the sums of a rig are, before its first sample.
#include "firmware/energy/energy_sums.hpp"

namespace firmware {
namespace {

bool measured_velocity(const CoreConfiguration& configuration, int node) {
  return node == kGroundNode || !configuration.signals[node][static_cast<int>(Quantity::kVelocity)].is_derived();
}

// Of the rate whose sign friction has.
RateGains sign_gains(const CoreConfiguration& configuration, RateGains gains) {
  if (!configuration.filters_sign()) return gains;
  gains.column_a = static_cast<uint16_t>(kSignVelocityColumn + gains.column_a / kQuantities);
  gains.column_b = static_cast<uint16_t>(kSignVelocityColumn + gains.column_b / kQuantities);
  return gains;
}

// Standard deviation of the link's rate in the unit of the coarser code, where the plan knows it: of velocities that were made from
// other channels or have passed the low-pass, with the doubt of the reading. The integral that a sign is taken from is another one.
Scaled rate_noise(const CoreConfiguration& configuration, const LinkConfiguration& link) {
  constexpr int kPlain = static_cast<int>(Weight::kPlain), kVelocity = static_cast<int>(Quantity::kVelocity);
  if (!kDerivesSignals) return {};
  Scaled variance, coarser;
  const int ends[] = {link.node_a, link.node_b};
  for (const int node : ends) {
    if (node == kGroundNode) continue;
    const SignalConfiguration& velocity = configuration.signals[node][kVelocity];
    const Scaled& noise = configuration.shared_noise[node][kPlain][kVelocity];
    if (velocity.integrations > 0) return {};
    if ((velocity.derived || configuration.sign_half_length > 0) && noise.is_positive())
      variance += noise * Scaled::ratio(1000 + configuration.motion_noise_doubt[node], 1000);
    if (coarser < velocity.unit_per_code) coarser = velocity.unit_per_code;
  }
  return coarser.is_zero() ? Scaled{} : sqrt(variance) / coarser;
}

}  // namespace

void EnergySums::configure(const CoreConfiguration& configuration, int weights) {
  configuration_ = &configuration;
  weights_ = weights;
  make_equation_plan(configuration, weights, plan_, sums_, layout_);
  effects_.configure(configuration, plan_.column_unit);
  const Scaled step = configuration.sample_period_s / 24;
  for (int p = 0; p < sums_.count(); ++p)
    integral_unit_[p] = step * plan_.column_unit[sums_.column_a(p)] * plan_.column_unit[sums_.column_b(p)];
  for (int l = 0; l < configuration.link_count; ++l) {
    const LinkConfiguration& link = configuration.links[l];
    gains_[l] = rate_gains(configuration, link);
    const bool white = measured_velocity(configuration, link.node_a) && measured_velocity(configuration, link.node_b);
    clear_sign_[l].configure(sign_gains(configuration, gains_[l]), white, configuration.high_pass_order > 0 && !white,
                             rate_noise(configuration, link));
    use_[l] = LinkUse{};
    use_[l].smooth_is_white = white;
  }
  any_shared_noise_ = false;
  for (const auto& node : configuration.shared_noise)
    for (const auto& weight : node)
      for (const Scaled& noise : weight) any_shared_noise_ = any_shared_noise_ || !noise.is_zero();
  any_crossings_ = false;
  for (int n = 0; n < plan_.incidence_count; ++n) {
    const Term& term = configuration.terms[plan_.incidence[n].term];
    if (!is_sign_term(term.kind)) continue;
    const DofProducts& dof = plan_.dof[plan_.incidence[n].dof];
    LinkUse& use = use_[term.place];
    use.has_sign = true;
    if (dof.clear_signs_only)
      use.wants_clear_sign = true;
    else
      use.wants_all_signs = true;
    if (!dof.has_acceleration) use.locates_crossings = any_crossings_ = true;
  }
  restart();
}

}  // namespace firmware

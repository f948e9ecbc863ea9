#include "firmware/warrant/probes/shared_noise.hpp"

namespace firmware {
namespace {

// Of a form's first and second quantity; kNone: it has no such quantity with noise of its own.
ProbeWeight weight_of(const Place& place, Form form, int quantity) {
  if (compares_channels(place.kind)) return ProbeWeight::kNone;  // both as measured
  if (form == Form::kJerk) return quantity == 0 ? ProbeWeight::kAccelerationSlope : ProbeWeight::kNone;
  if (form == Form::kForceRate) return ProbeWeight::kNone;  // a slope and its own sample share none
  if (place.kind == PlaceKind::kDof) return quantity == 0 ? ProbeWeight::kAcceleration : ProbeWeight::kForce;
  return quantity == 0 ? ProbeWeight::kDisplacement : ProbeWeight::kVelocity;
}

}  // namespace

Scaled SharedNoise::of_node(int node, ProbeWeight weight, Quantity quantity, Of of) const {
  if (node >= kMaxNodes || weight == ProbeWeight::kNone) return {};
  const ProbeNoise& noise = configuration_->probe_noise[node];
  const bool of_force = weight == ProbeWeight::kForce, with_force = quantity == Quantity::kForce;
  if (of_force != with_force) return {};
  const Scaled whole = of_force ? noise.force : noise.motion[static_cast<int>(weight)][static_cast<int>(quantity) - 1];
  if (of == Of::kWhole) return whole;
  const uint16_t* doubt = of_force ? configuration_->force_noise_doubt : configuration_->motion_noise_doubt;
  return whole * Scaled::ratio(doubt[node], 1000);
}

// The place's quantity is that of its first end less that of its second, the column likewise.
Scaled SharedNoise::of_ends(const Place& place, ProbeWeight weight, Quantity quantity, int node_a, int node_b,
                            Of of) const {
  const bool on_dof = place.kind == PlaceKind::kDof;
  const int mine[2] = {place.node_a, on_dof ? kGroundNode : place.node_b}, others[2] = {node_a, node_b};
  Scaled sum;
  for (int e = 0; e < 2; ++e)
    for (int f = 0; f < 2; ++f) {
      if (mine[e] != others[f] || mine[e] >= kMaxNodes) continue;
      const Scaled part = of_node(mine[e], weight, quantity, of);
      sum += e == f ? part : -part;
    }
  return sum;
}

Scaled SharedNoise::with_column(const Place& place, Form form, int quantity, int column, Of of) const {
  const ProbeWeight weight = weight_of(place, form, quantity);
  if (weight == ProbeWeight::kNone || column < kElongationColumn || column >= kForceLawColumn) return {};
  if (column >= kAccelerationColumn)
    return of_ends(place, weight, Quantity::kAcceleration, column - kAccelerationColumn, kGroundNode, of);
  if (column >= kSoftSignColumn) return {};
  const bool rate = column >= kRateColumn;
  const LinkConfiguration& link = configuration_->links[column - (rate ? kRateColumn : kElongationColumn)];
  return of_ends(place, weight, rate ? Quantity::kVelocity : Quantity::kDisplacement, link.node_a, link.node_b, of);
}

Scaled SharedNoise::with_known(const Place& place, Form form, int quantity, int dof, Of of) const {
  const ProbeWeight weight = weight_of(place, form, quantity);
  if (weight == ProbeWeight::kNone) return {};
  Scaled sum = of_ends(place, weight, Quantity::kForce, dof, kGroundNode, of);
  for (int s = 0; s < known_->shares(); ++s)
    if (known_->share(s).dof == dof)
      multiply_add(sum, known_->coefficient(s), with_column(place, form, quantity, known_->share(s).column, of));
  return sum;
}

}  // namespace firmware

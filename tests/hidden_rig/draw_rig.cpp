#include "draw_rig.hpp"

#include <algorithm>
#include <cmath>

namespace hidden_rig {
namespace {

void connect(TrueRig& rig, int a, int b) {
  TrueLink link;
  link.a = a;
  link.b = b;
  rig.links.push_back(link);
}

void connect_all(Dice& dice, Topology topology, int n, TrueRig& rig) {
  if (topology == Topology::kStar) {
    connect(rig, 0, kToGround);
    for (int i = 1; i < n; ++i) connect(rig, 0, i);
    for (int i = 1; i < n; ++i)
      if (dice.chance(0.3)) connect(rig, i, kToGround);
    return;
  }
  connect(rig, 0, kToGround);
  for (int i = 1; i < n; ++i) connect(rig, i - 1, i);
  if (topology == Topology::kRing) connect(rig, n - 1, 0);
  if (topology == Topology::kRing && dice.chance(0.5)) connect(rig, n / 2, kToGround);
  if (topology == Topology::kGrounded)
    for (int i = 1; i < n; ++i) connect(rig, i, kToGround);
  if (topology == Topology::kChain && n > 1 && dice.chance(0.6)) connect(rig, n - 1, kToGround);
}

}  // namespace

TrueRig draw_rig(Dice& dice, const Condition& c, int masses) {
  TrueRig rig;
  rig.rotating = c.rotating;
  const int n = masses > 0 ? masses : c.least_masses + dice.below(c.most_masses - c.least_masses + 1);
  for (int i = 0; i < n; ++i) rig.mass_kg.push_back(dice.between(0.6, 2.5) * c.mass_scale);
  connect_all(dice, c.topology, n, rig);
  const bool decays = c.excitation == Excitation::kFreeDecay || c.excitation == Excitation::kFreeDecayToRest;
  for (TrueLink& link : rig.links) {
    link.k = dice.log_between(4e3, 3e4) * c.mass_scale * c.pace * c.pace;
    link.c = dice.log_between(8, 40) * c.mass_scale * c.pace * (decays ? 0.15 : 1);
    if (c.excitation == Excitation::kBase && link.b == kToGround && (&link == &rig.links[0] || dice.chance(0.5)))
      link.b = kToBase;
  }
  return rig;
}

void draw_friction(Dice& dice, const Condition& c, TrueRig& rig, const Motion& motion) {
  for (size_t l = 0; l < rig.links.size(); ++l) {
    TrueLink& link = rig.links[l];
    const double damping = rms(motion.damping_force[l]);
    if (c.excitation == Excitation::kFreeDecay || c.excitation == Excitation::kFreeDecayToRest) {
      const bool ends = c.excitation == Excitation::kFreeDecayToRest;
      const double deflection = std::abs((link.a >= 0 ? motion.x[static_cast<size_t>(link.a)][0] : 0) -
                                         (link.b >= 0 ? motion.x[static_cast<size_t>(link.b)][0] : 0));
      const double share = dice.log_between(1, 6) * (ends ? 5e-3 : 5e-4);
      if (dice.chance(0.35) || (ends && l == 0)) link.F = share * link.k * deflection;
    } else if (c.friction == Friction::kSticking) {
      if (l == 0 || dice.chance(0.6)) link.F = dice.between(0.8, 1.6) * damping;
    } else if (dice.chance(0.35)) {
      link.F = dice.between(0.1, 0.45) * damping;
    }
  }
}

}  // namespace hidden_rig

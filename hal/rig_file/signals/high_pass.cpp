#include "hal/rig_file/signals/high_pass.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signals/planned.hpp"

namespace rig_file {
namespace {

using firmware::CoreConfiguration;

// Corner for one integration and for two; the nearest power of two is taken. Two need the higher one: noise and the start of
// a level grow with the square of the time that they are remembered. What drives a rig has little below the rig's own motion, and slow
// noise is left out from a higher corner on; a decay needs its first seconds, friction beside it and all.
constexpr double kHighPass_Hz = 0.2, kDrivenHighPass_Hz = 0.5, kDoubleHighPass_Hz = 1.0;
// The time constant of a corner that follows a fast motion up, in octaves of a period of the slowest motion. One integration has settled
// within one time constant (conditioning), so it may take eight periods. Two take 16 time constants: half a period. The corner is then a
// factor pi below the motion, and the velocity of friction's sign, whose corner is eight times lower, leads by 0.08 rad there: of
// drawn rigs one friction in nine was then outside its 95 % interval, up to 4 % off. With a whole period one in 20 is.
constexpr int kPeriodOfOne = 3, kPeriodOfTwo = -1, kPeriodOfTwoWithFriction = 0;
constexpr int kLeastHighPassShift = firmware::kIntegrationExtraBits, kMostHighPassShift = 12;

bool driven(const CoreConfiguration& c) {
  bool force = c.base_present;
  for (int node = 0; node < c.dof_count; ++node) force = force || c.channels[node][kF].present;
  return force;
}

// There the score tests take friction's sign from the velocity that has passed the high-pass.
bool friction_without_acceleration(const CoreConfiguration& c) {
  for (int t = 0; t < c.term_count; ++t) {
    if (!firmware::is_sign_term(c.terms[t].kind)) continue;
    const firmware::LinkConfiguration& link = c.links[c.terms[t].place];
    for (const int node : {int{link.node_a}, int{link.node_b}})
      if (node < c.dof_count && !c.signals[node][kA].available) return true;
  }
  return false;
}

}  // namespace

void choose_high_pass(CoreConfiguration& c, const SignalRanges& ranges) {
  const int integrations = most_integrations(c);
  c.high_pass_order = static_cast<uint8_t>(integrations == 0 ? 0 : integrations + 1);
  const double once_Hz = driven(c) && !friction_without_acceleration(c) ? kDrivenHighPass_Hz : kHighPass_Hz;
  const double corner_Hz = integrations > 1 ? kDoubleHighPass_Hz : once_Hz;
  const double shift = std::log2(1.0 / (2.0 * M_PI * corner_Hz * to_double(c.sample_period_s)));
  int nearest = std::clamp(static_cast<int>(std::lround(shift)), kLeastHighPassShift, kMostHighPassShift);
  if (ranges.octaves_to_slowest_motion)
    nearest = std::clamp(*ranges.octaves_to_slowest_motion + octaves_of_period(c), kLeastHighPassShift, nearest);
  c.high_pass_shift = static_cast<uint8_t>(nearest);
}

int octaves_of_period(const CoreConfiguration& c) {
  if (most_integrations(c) < 2) return kPeriodOfOne;
  return has_friction(c) ? kPeriodOfTwoWithFriction : kPeriodOfTwo;
}

}  // namespace rig_file

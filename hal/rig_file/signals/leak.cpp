#include "hal/rig_file/signals/leak.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signals/planned.hpp"

namespace rig_file {
namespace {

using firmware::CoreConfiguration;

// Time constant of a fusion: 16 to 1024 sample periods.
constexpr int kLeastLeak = 4, kMiddleLeak = 5, kMostLeak = 10;

double own_frequency_square(const CoreConfiguration& c, int node) {
  double mass = 0.0, stiffness = 0.0;
  for (int t = 0; t < c.term_count; ++t) {
    const firmware::Term& term = c.terms[t];
    if (term.kind == firmware::TermKind::kMass && term.place == node) mass = to_double(term.value);
    if (term.kind != firmware::TermKind::kStiffness) continue;
    const firmware::LinkConfiguration& link = c.links[term.place];
    if (link.node_a == node || link.node_b == node) stiffness += to_double(term.value);
  }
  return mass > 0.0 ? stiffness / mass : 0.0;
}

// The core begins two time constants after a record does. A motion that is over by then has not been seen.
int longest_leak(double moving_samples) {
  constexpr double kTimeConstants = 2.0, kMostOfMotion = 0.5;
  if (!(moving_samples > 0.0)) return kMostLeak;
  const double longest = std::log2(kMostOfMotion * moving_samples / kTimeConstants);
  return std::clamp(static_cast<int>(longest), kLeastLeak, kMostLeak);
}

}  // namespace

// The corner at which x' of white noise sx and the integral of an acceleration of white noise sa add the least noise:
// variance w^2 sx^2 + sa^2 T / (2 w), least at w^3 = sa^2 T / (4 sx^2). Where the noise is not known, that of sensors which
// are equally good at the node's own frequency w0, sqrt(k / m): sa = w0^2 sx.
int leak_shift(const CoreConfiguration& c, const SignalRanges& ranges, int node) {
  const double period_s = to_double(c.sample_period_s);
  const auto noise = [&](int q) {
    return ranges.noise[node][q].deviation * to_double(c.channels[node][q].unit_per_code);
  };
  const double sx = noise(kX), sa = noise(kA);
  const double ratio = sx > 0.0 && sa > 0.0 ? sa / sx : own_frequency_square(c, node);
  const int most = longest_leak(ranges.moving_samples[node]);
  if (!(ratio > 0.0)) return std::min(kMiddleLeak, most);
  const double corner = std::cbrt(ratio * ratio * period_s / 4.0);
  return std::clamp(static_cast<int>(std::lround(-std::log2(corner * period_s))), kLeastLeak, most);
}

}  // namespace rig_file

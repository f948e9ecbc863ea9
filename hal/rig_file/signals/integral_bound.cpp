#include "hal/rig_file/signals/integral_bound.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/recorded/shared_noise.hpp"

namespace rig_file {
namespace {

using firmware::CoreConfiguration;

double magnitudes(const std::vector<double>& response) {
  double sum = 0.0;
  for (const double value : response) sum += std::fabs(value);
  return sum;
}

}  // namespace

// The core divides each integral by its time constant, so the bound is that of any time constant, but for the response's edges, where
// the filter adds to it: they count least where the time constant is long. What holds at 256 samples holds for more.
IntegralBound integral_bound(const CoreConfiguration& c, int node, int q, const Impulse& impulse) {
  constexpr int kLongest = 8, kForgotten = 24;  // time constants
  CoreConfiguration brief = c;
  brief.high_pass_shift = static_cast<uint8_t>(std::min<int>(c.high_pass_shift, kLongest));
  brief.signals[node][q].dropped_bits = 0;
  std::vector<double> response(size_t{kForgotten} << brief.high_pass_shift, 0.0);
  response[1] = 1.0;  // the first sample is taken to have stood there for ever
  high_pass(brief, node, q, response);
  const firmware::ChannelConfiguration& channel = c.channels[node][c.signals[node][q].source];
  const double half_way = 0.5 * (static_cast<double>(channel.highest_code) - channel.lowest_code);
  IntegralBound bound;
  bound.integral = half_way * magnitudes(response);
  bound.signal = half_way * magnitudes(convolve(response, impulse));
  return bound;
}

}  // namespace rig_file

#include <algorithm>

#include "hal/rig_file/recorded/motion_band.hpp"
#include "hal/rig_file/recorded/moving_samples.hpp"
#include "hal/rig_file/recorded/slowest_motion.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "hal/rig_file/signals/high_pass.hpp"
#include "hal/rig_file/signals/largest.hpp"
#include "hal/rig_file/signals/planned.hpp"

namespace rig_file {

using firmware::CoreConfiguration;
using firmware::kQuantities;
using firmware::SignalConfiguration;

namespace {

using Records = std::vector<std::vector<firmware::RawSample>>;

void read_noise_of(const CoreConfiguration& c, const Records& records, int q, SignalRanges& ranges) {
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    if (c.channels[node][q].present)
      ranges.noise[node][q] = read_noise(codes_of(records, node, q), q, 1.0 / to_double(c.sample_period_s));
}

}  // namespace

SignalRanges measure_ranges(const CoreConfiguration& configuration, const Records& records, Corner corner) {
  SignalRanges ranges;
  read_noise_of(configuration, records, kX, ranges);
  if (!filtered(configuration) && !coloured_displacement(configuration, ranges)) return ranges;  // asks for no more
  for (const int q : {kF, kV, kA}) read_noise_of(configuration, records, q, ranges);
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    if (configuration.fusion[node].used)
      ranges.moving_samples[node] = fewest_moving_samples(codes_of(records, node, kX));
  CoreConfiguration planned = configuration;
  if (corner == Corner::kBelowMotion && planned.high_pass_order > 0) {
    const int as_configured = planned.high_pass_shift - octaves_of_period(planned);
    ranges.octaves_to_slowest_motion = octaves_to_slowest_motion(planned, records, ranges.noise, as_configured);
    if (*ranges.octaves_to_slowest_motion < as_configured) plan_signals(planned, ranges);
  }
  if (differentiates(planned)) {
    for (int node = 0; node < firmware::kMaxNodes; ++node)
      for (const int q : {kX, kV}) {
        const bool told = planned.channels[node][q].present && (q == kX || planned.signals[node][kA].source == kV);
        ranges.wide_band = ranges.wide_band || (told && moves_beyond_a_tenth(records, node, q, ranges.noise[node][q]));
      }
    if (ranges.wide_band) plan_signals(planned, ranges);
  }
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q) {
      const SignalConfiguration& signal = planned.signals[node][q];
      if (!signal.available || (signal.half_length == 0 && signal.tap[0].raw == 0)) continue;
      for (const auto& record : records)
        ranges.largest[node][q] = std::max(ranges.largest[node][q], largest_value(planned, node, q, record));
    }
  return ranges;
}

}  // namespace rig_file

#include "hal/rig_file/signal_plan.hpp"

#include <algorithm>

#include "hal/rig_file/recorded/shared_noise.hpp"
#include "hal/rig_file/signals/planned.hpp"
#include "hal/rig_file/signals/sources.hpp"
#include "hal/rig_file/signals/taps.hpp"

namespace rig_file {

using firmware::CoreConfiguration;
using firmware::kQuantities;
using firmware::SignalConfiguration;

void plan_signals(CoreConfiguration& configuration, const SignalRanges& ranges) {
  choose_sources(configuration, ranges);
  for (auto& node : configuration.shared_noise)
    for (auto& weight : node)
      for (firmware::Scaled& product : weight) product = {};
  for (firmware::ProbeNoise& node : configuration.probe_noise) node = {};
  configuration.noise_unknown = configuration.shares_probe_noise = false;
  std::fill_n(configuration.motion_noise_doubt, firmware::kMaxNodes, uint16_t{0});
  std::fill_n(configuration.force_noise_doubt, firmware::kMaxNodes, uint16_t{0});
  configuration.sign_half_length = 0;
  if (!filtered(configuration)) {
    if (coloured_displacement(configuration, ranges)) find_shared_noise(configuration, ranges);
    return;
  }
  make_filters(configuration, ranges);
  find_shared_noise(configuration, ranges);
}

std::string describe_plan(const CoreConfiguration& planned) {
  static const char* const kNames[kQuantities] = {"force", "displacement", "velocity", "acceleration"};
  std::string text;
  for (int node = 0; node < firmware::kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q) {
      const SignalConfiguration& signal = planned.signals[node][q];
      if (!signal.available || !signal.derived) continue;
      text += text.empty() ? "" : "; ";
      text += std::string(kNames[q]) + " of " + node_name(node) +
              (q == kV && planned.fusion[node].used ? " fused from displacement and acceleration"
                                                    : std::string(" derived from ") + kNames[signal.source]);
    }
  return text;
}

}  // namespace rig_file

#include "firmware/configuration/configuration.hpp"

namespace firmware {

CoreConfiguration::CoreConfiguration() = default;

void copy_measured_signals(CoreConfiguration& configuration) {
  for (int node = 0; node < kMaxNodes; ++node) {
    for (int quantity = 0; quantity < kQuantities; ++quantity) {
      const ChannelConfiguration& channel = configuration.channels[node][quantity];
      SignalConfiguration& signal = configuration.signals[node][quantity];
      signal = SignalConfiguration{};
      signal.available = channel.present;
      signal.source = static_cast<uint8_t>(quantity);
      signal.unit_per_code = channel.unit_per_code;
    }
  }
}

}  // namespace firmware

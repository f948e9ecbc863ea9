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

const Term* term_of(const CoreConfiguration& configuration, int unknown) {
  for (int t = 0; t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown == unknown) return &configuration.terms[t];
  return nullptr;
}

}  // namespace firmware

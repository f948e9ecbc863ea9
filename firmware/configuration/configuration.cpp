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

int full_scale_bits(const CoreConfiguration& configuration, int node, Quantity quantity, int least) {
  constexpr int kAll = 23;
  const SignalConfiguration& signal = configuration.signals[node][static_cast<int>(quantity)];
  const bool as_measured = signal.half_length == 0 && signal.tap[0].raw == 0 && signal.integrations == 0;
  if (!signal.available || !as_measured) return kAll;
  const ChannelConfiguration& channel = configuration.channels[node][signal.source];
  const int64_t above = int64_t{channel.highest_code} - channel.offset_code,
                below = int64_t{channel.offset_code} - channel.lowest_code;
  const int64_t largest = above > below ? above : below;
  int bits = least;
  while (bits < kAll && largest > int64_t{1} << bits) ++bits;
  return bits;
}

const Term* term_of(const CoreConfiguration& configuration, int unknown) {
  for (int t = 0; t < configuration.term_count; ++t)
    if (configuration.terms[t].unknown == unknown) return &configuration.terms[t];
  return nullptr;
}

}  // namespace firmware

// One list of fields, walked by a writer, a reader and a check sum.
#include "firmware/rig_controller/settings/controller_configuration.hpp"

#include <new>

#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "firmware/configuration/bytes.hpp"
#include "firmware/rig_controller/encoding/archives.hpp"
#include "firmware/rig_controller/encoding/controller_fields.hpp"

namespace firmware {
namespace {

constexpr uint32_t kVersion = 0x52433038;  // "RC08": changes with the list of fields

// Every filter at its longest (a fused velocity's two are shorter together); everything else has one length. Version before it and check sum behind it.
constexpr size_t longest_encoding() {
  ControllerConfiguration longest{CoreConfiguration(CoreConfiguration::AtCompileTime()), {}, {}, {}};
  longest.core.shares_probe_noise = true;
  longest.core.sign_half_length = kSignFilterHalf;
  longest.core.dof_count = kMaxDofs;
  longest.core.link_count = kMaxLinks;
  longest.core.term_count = kMaxTerms;
  longest.core.base_present = kHasBase;
  longest.programme.level_count = kMaxLevels;
  for (auto& node : longest.core.signals)
    for (SignalConfiguration& signal : node) {
      signal.half_length = kFilterHalf;
      signal.derived = true;
    }
  Counter counter;
  counter.field(kVersion);
  walk_rig(counter, longest);
  walk_node(counter, longest.node);
  counter.field(uint32_t{});
  return counter.size();
}
static_assert(longest_encoding() <= kConfigurationBytes, "see kConfigurationBytes");

Writer write(const ControllerConfiguration& configuration, uint8_t* bytes, size_t capacity) {
  Writer writer(bytes, capacity);
  writer.field(kVersion);
  walk_rig(writer, configuration);
  walk_node(writer, configuration.node);
  return writer;
}

constexpr size_t kVersionBytes = 4, kCrcBytes = 4;

bool whole(const uint8_t* bytes, size_t size) {
  if (size < kVersionBytes + kCrcBytes || get32(bytes) != kVersion) return false;
  Crc32 crc;
  for (size_t i = 0; i + kCrcBytes < size; ++i) crc.add(bytes[i]);
  return crc.value() == get32(bytes + size - kCrcBytes);
}

}  // namespace

size_t encode(const ControllerConfiguration& configuration, uint8_t (&bytes)[kConfigurationBytes]) {
  Writer writer = write(configuration, bytes, kConfigurationBytes);
  writer.field(writer.crc());
  return writer.size();
}

bool decode(const uint8_t* bytes, size_t size, ControllerConfiguration& configuration) {
  if (!whole(bytes, size)) return false;
  Reader reader(bytes + kVersionBytes, size - kVersionBytes - kCrcBytes);
  new (&configuration) ControllerConfiguration;  // what is not in use stands as it starts
  walk_rig(reader, configuration);
  walk_node(reader, configuration.node);
  return !reader.overrun() && reader.read() == size - kVersionBytes - kCrcBytes;
}

Stored read_stored(const uint8_t* bytes, size_t size, const ControllerConfiguration& own, NodeConfiguration& node) {
  if (!whole(bytes, size)) return Stored::kDamaged;
  const size_t fields = size - kVersionBytes - kCrcBytes;
  Comparer comparer(bytes + kVersionBytes, fields);
  walk_rig(comparer, own);
  if (!comparer.same()) return Stored::kOfAnotherRig;
  Reader reader(bytes + kVersionBytes + comparer.read(), fields - comparer.read());
  NodeConfiguration stored;
  walk_node(reader, stored);
  if (reader.overrun() || reader.read() != fields - comparer.read()) return Stored::kDamaged;
  node = stored;
  return Stored::kOfThisRig;
}

uint32_t configuration_crc(const ControllerConfiguration& configuration) {
  return write(configuration, nullptr, 0).crc();
}

bool sends_float_estimates(const ControllerConfiguration& configuration) {
  const NodeConfiguration& node = configuration.node;
  if (node.float_estimates != FloatEstimates::kWhereLoadAllows) return node.float_estimates == FloatEstimates::kAlways;
  const CoreConfiguration& core = configuration.core;
  const Scaled window_us = core.sample_period_s * Scaled::from_int(int64_t{1000000} * node.window_samples);
  return float_estimates_fit(core.unknown_count, to_fixed(window_us, 0), node.can_fd);
}

}  // namespace firmware

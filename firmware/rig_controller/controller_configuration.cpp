// One list of fields, walked by a writer, a reader and a check sum.
#include "firmware/rig_controller/controller_configuration.hpp"

#include <type_traits>

#include "firmware/can_protocol/estimate_frames.hpp"
#include "firmware/configuration/bytes.hpp"

namespace firmware {
namespace {

constexpr uint32_t kVersion = 0x52433036;  // "RC06": changes with the list of fields

// Bytes go to a buffer where there is one, and into the check sum.
class Writer {
 public:
  Writer(uint8_t* bytes, size_t capacity) : bytes_(bytes), capacity_(capacity) {}
  template <typename T>
  void field(const T& value) {
    const auto bits = static_cast<uint64_t>(static_cast<int64_t>(value));
    for (size_t i = 0; i < sizeof(T); ++i) put(static_cast<uint8_t>(bits >> (8 * i)));
  }
  template <typename T>
  void clear(const T&) {}
  size_t size() const { return size_; }
  uint32_t crc() const { return crc_.value(); }

 private:
  void put(uint8_t byte) {
    crc_.add(byte);
    if (size_ < capacity_) bytes_[size_] = byte;
    ++size_;
  }
  uint8_t* bytes_;
  size_t capacity_;
  size_t size_ = 0;
  Crc32 crc_;
};

// Bytes alone, for the length of the longest configuration.
class Counter {
 public:
  template <typename T>
  constexpr void field(const T&) {
    size_ += sizeof(T);
  }
  template <typename T>
  constexpr void clear(const T&) {}
  constexpr size_t size() const { return size_; }

 private:
  size_t size_ = 0;
};

class Reader {
 public:
  Reader(const uint8_t* bytes, size_t size) : bytes_(bytes), size_(size) {}
  template <typename T>
  void field(T& value) {
    uint64_t bits = 0;
    for (size_t i = 0; i < sizeof(T); ++i) bits |= static_cast<uint64_t>(next()) << (8 * i);
    if constexpr (std::is_same<T, bool>::value) {
      value = bits != 0;
    } else {
      value = static_cast<T>(bits);
    }
  }
  template <typename T, size_t N>
  void clear(T (&values)[N]) {
    for (T& value : values) value = T{};
  }
  size_t read() const { return place_; }
  bool overrun() const { return place_ > size_; }

 private:
  uint8_t next() { return place_ < size_ ? bytes_[place_++] : (++place_, uint8_t{0}); }
  const uint8_t* bytes_;
  size_t size_;
  size_t place_ = 0;
};

// Whether bytes are those of a configuration in memory.
class Comparer {
 public:
  Comparer(const uint8_t* bytes, size_t size) : reader_(bytes, size) {}
  template <typename T>
  void field(const T& value) {
    T stored{};
    reader_.field(stored);
    same_ = same_ && stored == value;
  }
  template <typename T>
  void clear(const T&) {}
  bool same() const { return same_ && !reader_.overrun(); }
  size_t read() const { return reader_.read(); }

 private:
  Reader reader_;
  bool same_ = true;
};

template <typename Archive, typename Number>
constexpr void walk_scaled(Archive& archive, Number& number) {
  archive.field(number.mantissa);
  archive.field(number.exponent);
}

template <typename Archive, typename Channel>
constexpr void walk_channel(Archive& archive, Channel& channel) {
  archive.field(channel.present);
  archive.field(channel.offset_code);
  archive.field(channel.lowest_code);
  archive.field(channel.highest_code);
  walk_scaled(archive, channel.unit_per_code);
  archive.field(channel.delay_ns);
}

// Taps beyond the filter's length are zero and are left out.
template <typename Archive, typename Signal>
constexpr void walk_signal(Archive& archive, Signal& signal) {
  archive.field(signal.available);
  archive.field(signal.derived);
  archive.field(signal.source);
  archive.field(signal.integrations);
  archive.field(signal.half_length);
  archive.field(signal.shift);
  archive.clear(signal.tap);
  for (int i = 0; i <= 2 * signal.half_length && i <= 2 * kFilterHalf; ++i) archive.field(signal.tap[i].raw);
  walk_scaled(archive, signal.unit_per_code);
}

// What follows `used` is there where it says so; taps beyond the filter's length are zero and are left out.
template <typename Archive, typename Fusion>
constexpr void walk_fusion(Archive& archive, Fusion& fusion, int half_length) {
  archive.field(fusion.used);
  archive.field(fusion.leak_shift);
  archive.clear(fusion.step_tap);
  if (!fusion.used) return;
  for (int i = 0; i <= 2 * half_length && i <= 2 * kFusionHalf; ++i) archive.field(fusion.step_tap[i].raw);
}

// Noise that a derived velocity shares with its neighbours; none elsewhere.
template <typename Archive, typename Core>
constexpr void walk_shared_noise(Archive& archive, Core& core) {
  for (int node = 0; node < kMaxNodes; ++node) {
    const bool derived = core.signals[node][static_cast<int>(Quantity::kVelocity)].derived;
    for (auto& weight : core.shared_noise[node]) {
      archive.clear(weight);
      if (!derived) continue;
      for (int q = 1; q < kQuantities; ++q) walk_scaled(archive, weight[q]);
    }
  }
}

template <typename Archive, typename Core>
constexpr void walk_probe_noise(Archive& archive, Core& core) {
  archive.field(core.shares_probe_noise);
  archive.field(core.noise_unknown);
  for (auto& node : core.probe_noise) {
    for (auto& weight : node.motion) {
      archive.clear(weight);
      for (auto& covariance : weight)
        if (core.shares_probe_noise) walk_scaled(archive, covariance);
    }
    if (core.shares_probe_noise) walk_scaled(archive, node.force);
  }
}

template <typename Archive, typename Core>
constexpr void walk_sign_filter(Archive& archive, Core& core) {
  archive.field(core.sign_half_length);
  archive.clear(core.sign_tap);
  for (int k = 0; k <= 2 * core.sign_half_length && k <= 2 * kSignFilterHalf; ++k) archive.field(core.sign_tap[k].raw);
}

template <typename Archive, typename Core>
constexpr void walk_core(Archive& archive, Core& core) {
  archive.field(core.dof_count);
  archive.field(core.link_count);
  archive.field(core.term_count);
  archive.field(core.unknown_count);
  archive.field(core.base_present);
  walk_scaled(archive, core.sample_period_s);
  for (auto& link : core.links) {
    archive.field(link.node_a);
    archive.field(link.node_b);
  }
  for (auto& term : core.terms) {
    archive.field(term.kind);
    archive.field(term.place);
    archive.field(term.unknown);
    walk_scaled(archive, term.value);
    walk_scaled(archive, term.shape);
    archive.field(term.second_shape_q26);
  }
  for (auto& node : core.channels)
    for (auto& channel : node) walk_channel(archive, channel);
  for (auto& node : core.signals)
    for (auto& signal : node) walk_signal(archive, signal);
  for (int node = 0; node < kMaxNodes; ++node)
    walk_fusion(archive, core.fusion[node], core.signals[node][static_cast<int>(Quantity::kVelocity)].half_length);
  walk_shared_noise(archive, core);
  walk_probe_noise(archive, core);
  archive.field(core.high_pass_order);
  archive.field(core.high_pass_shift);
  walk_sign_filter(archive, core);
  archive.field(core.window.mode);
  archive.field(core.window.cycle_samples_numerator);
  archive.field(core.window.cycle_samples_denominator);
  archive.field(core.window.batch_samples);
  archive.field(core.probe_products_per_sample);
}

template <typename Archive, typename Level>
constexpr void walk_level(Archive& archive, Level& level) {
  archive.field(level.kind);
  archive.field(level.amplitude.raw);
  archive.field(level.phase_step);
  archive.field(level.high_phase_step);
  archive.field(level.seed);
  archive.field(level.ramp_samples);
  archive.field(level.settle.block_samples);
  archive.field(level.settle.bound_per_mille);
  archive.field(level.settle.blocks);
  archive.field(level.settle.floor_code);
  archive.field(level.settle_limit_samples);
  archive.field(level.skip_when_unsettled);
  archive.field(level.measure_samples);
}

template <typename Archive, typename Programme>
constexpr void walk_programme(Archive& archive, Programme& programme) {
  archive.field(programme.level_count);
  archive.field(programme.start_at_boot);
  archive.field(programme.limits.magnitude.raw);
  archive.field(programme.limits.step_per_sample.raw);
  for (auto& level : programme.levels) walk_level(archive, level);
}

template <typename Archive, typename Limits>
constexpr void walk_limits(Archive& archive, Limits& limits) {
  archive.field(limits.saturated_in_row);
  archive.field(limits.lost_in_row);
  archive.field(limits.sample_timeout_us);
  archive.field(limits.step_timeout_us);
  for (auto& node : limits.response_limit_code)
    for (auto& code : node) archive.field(code);
}

template <typename Archive, typename Node>
constexpr void walk_node(Archive& archive, Node& node) {
  archive.field(node.node);
  archive.field(node.can_fd);
  archive.field(node.float_estimates);
  archive.field(node.sync_closes_window);
  archive.field(node.listen_on_command);
  archive.field(node.drive_on_can);
  archive.field(node.heartbeat_ms);
  archive.field(node.status_ms);
  archive.field(node.emergency_inhibit_ms);
  archive.field(node.window_samples);
  archive.field(node.rotating_nodes);
}

template <typename Archive, typename Configuration>
constexpr void walk_rig(Archive& archive, Configuration& configuration) {
  walk_core(archive, configuration.core);
  walk_programme(archive, configuration.programme);
  walk_limits(archive, configuration.limits);
}

// Every filter at its longest (a fused velocity's two are shorter together); everything else has one length. Version before it and check sum behind it.
constexpr size_t longest_encoding() {
  ControllerConfiguration longest;
  longest.core.shares_probe_noise = true;
  longest.core.sign_half_length = kSignFilterHalf;
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
static_assert(longest_encoding() <= kConfigurationBytes, "a store must take the largest configuration");

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

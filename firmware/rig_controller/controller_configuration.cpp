// One list of fields, walked by a writer, a reader and a check sum.
#include "firmware/rig_controller/controller_configuration.hpp"

#include <new>
#include <type_traits>

#include "firmware/can_protocol/estimate_frames.hpp"
#include "firmware/configuration/bytes.hpp"

namespace firmware {
namespace {

constexpr int kMostWeights = 3;
constexpr uint32_t kVersion = 0x52433037;  // "RC07": changes with the list of fields

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
  void node(uint8_t number) { field(static_cast<uint8_t>(wire_node(number))); }
  static int count(int number, int) { return number; }
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
  constexpr void node(uint8_t) { ++size_; }
  static constexpr int count(int number, int) { return number; }
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
  void node(uint8_t& number) {
    const int index = node_of_wire(next());
    refused_ = refused_ || index < 0;
    number = static_cast<uint8_t>(index < 0 ? kGroundNode : index);
  }
  // What does not fit this core is refused.
  int count(int number, int capacity) {
    refused_ = refused_ || number > capacity;
    return number > capacity ? capacity : number;
  }
  size_t read() const { return place_; }
  bool overrun() const { return refused_ || place_ > size_; }

 private:
  uint8_t next() { return place_ < size_ ? bytes_[place_++] : (++place_, uint8_t{0}); }
  const uint8_t* bytes_;
  size_t size_;
  size_t place_ = 0;
  bool refused_ = false;
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
  void node(uint8_t number) { field(static_cast<uint8_t>(wire_node(number))); }
  static int count(int number, int) { return number; }
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
  const int half = archive.count(signal.half_length, kFilterHalf);
  for (int i = 0; i <= 2 * half; ++i) archive.field(signal.tap[i].raw);
  walk_scaled(archive, signal.unit_per_code);
}

// What follows `used` is there where it says so; taps beyond the filter's length are zero and are left out.
template <typename Archive, typename Fusion>
constexpr void walk_fusion(Archive& archive, Fusion& fusion, int half_length) {
  archive.field(fusion.used);
  archive.field(fusion.leak_shift);
  archive.clear(fusion.step_tap);
  if (!fusion.used) return;
  const int half = archive.count(half_length, kFusionHalf);
  for (int i = 0; i <= 2 * half; ++i) archive.field(fusion.step_tap[i].raw);
}

// The nodes in use, the base last.
template <typename Core, typename Visit>
constexpr void for_each_node(const Core& core, int dofs, Visit visit) {
  for (int node = 0; node < dofs; ++node) visit(node);
  if (kHasBase && core.base_present) visit(kBaseNode);
}

// Noise that a derived velocity shares with its neighbours; none elsewhere.
template <typename Archive, typename Noise>
constexpr void walk_shared_noise(Archive& archive, Noise& noise, bool derived) {
  for (auto& weight : noise) {
    archive.clear(weight);
    if (!derived) continue;
    for (int q = 1; q < kQuantities; ++q) walk_scaled(archive, weight[q]);
  }
  for (int unused = (kMostWeights - kWeights) * (kQuantities - 1); derived && unused > 0; --unused) {
    Scaled none;
    walk_scaled(archive, none);
  }
}

// Noise that the score tests take out; there where it is shared.
template <typename Archive, typename Core>
constexpr void walk_probe_noise(Archive& archive, Core& core, int node) {
  auto& noise = core.probe_noise[kKeepsProbeNoise ? node : 0];
  for (auto& weight : noise.motion) {
    archive.clear(weight);
    for (auto& covariance : weight)
      if (core.shares_probe_noise) walk_scaled(archive, covariance);
  }
  if (core.shares_probe_noise) walk_scaled(archive, noise.force);
  archive.field(core.motion_noise_doubt[node]);
  archive.field(core.force_noise_doubt[node]);
}

// Of a node: its channels, what the equations use of them, and how a velocity is fused.
template <typename Archive, typename Core>
constexpr void walk_signals(Archive& archive, Core& core, int node) {
  for (auto& channel : core.channels[node]) walk_channel(archive, channel);
  for (auto& signal : core.signals[node]) walk_signal(archive, signal);
  const auto& velocity = core.signals[node][static_cast<int>(Quantity::kVelocity)];
  walk_fusion(archive, core.fusion[node], velocity.half_length);
  walk_shared_noise(archive, core.shared_noise[node], velocity.derived);
  walk_probe_noise(archive, core, node);
}

template <typename Archive, typename Core>
constexpr void walk_sign_filter(Archive& archive, Core& core) {
  archive.field(core.sign_half_length);
  archive.clear(core.sign_tap);
  const int half = archive.count(core.sign_half_length, kSignFilterHalf);
  for (int k = 0; k <= 2 * half; ++k) archive.field(core.sign_tap[k].raw);
}

// Counts first, then what is in use: a core of another capacity reads the same bytes.
template <typename Archive, typename Core>
constexpr void walk_core(Archive& archive, Core& core) {
  archive.field(core.dof_count);
  archive.field(core.link_count);
  archive.field(core.term_count);
  archive.field(core.unknown_count);
  archive.field(core.base_present);
  const int dofs = archive.count(core.dof_count, kMaxDofs), links = archive.count(core.link_count, kMaxLinks);
  const int terms = archive.count(core.term_count, kMaxTerms);
  archive.count(core.unknown_count, kMaxUnknowns);
  archive.count(core.base_present ? 1 : 0, kHasBase ? 1 : 0);
  archive.field(core.shares_probe_noise);
  archive.field(core.noise_unknown);
  walk_scaled(archive, core.sample_period_s);
  for (int l = 0; l < links; ++l) {
    archive.node(core.links[l].node_a);
    archive.node(core.links[l].node_b);
  }
  for (int t = 0; t < terms; ++t) {
    auto& term = core.terms[t];
    archive.field(term.kind);
    archive.field(term.place);
    archive.field(term.unknown);
    walk_scaled(archive, term.value);
    walk_scaled(archive, term.shape);
    archive.field(term.second_shape_q26);
  }
  for_each_node(core, dofs, [&](int node) { walk_signals(archive, core, node); });
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
  const int levels = archive.count(programme.level_count, kMaxLevels);
  for (int l = 0; l < levels; ++l) walk_level(archive, programme.levels[l]);
}

template <typename Archive, typename Limits, typename Core>
constexpr void walk_limits(Archive& archive, Limits& limits, const Core& core) {
  archive.field(limits.saturated_in_row);
  archive.field(limits.lost_in_row);
  archive.field(limits.sample_timeout_us);
  archive.field(limits.step_timeout_us);
  for_each_node(core, archive.count(core.dof_count, kMaxDofs), [&](int node) {
    for (auto& code : limits.response_limit_code[node]) archive.field(code);
  });
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
  walk_limits(archive, configuration.limits, configuration.core);
}

// Every filter at its longest (a fused velocity's two are shorter together); everything else has one length. Version before it and check sum behind it.
constexpr size_t longest_encoding() {
  ControllerConfiguration longest;
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

// The configuration in bytes: everything comes back, every change shows in the check sum, damage is refused.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "tests/rig_controller/bench.hpp"

namespace {

using firmware::ControllerConfiguration;

// A field that is added to one of these structs must be added to the list in controller_configuration.cpp and to
// kChanges; the sizes are here to remind of it.
static_assert(sizeof(firmware::NodeConfiguration) == 20, "a field was added or removed: see above");
static_assert(sizeof(firmware::ExcitationLevel) == 48, "a field was added or removed: see above");
static_assert(sizeof(firmware::ChannelConfiguration) == 32, "a field was added or removed: see above");
static_assert(sizeof(firmware::SignalConfiguration) == 8 + 4 * (2 * firmware::kFilterHalf + 1) + 12,
              "a field was added or removed: see above");
static_assert(sizeof(firmware::WindowConfiguration) == 16, "a field was added or removed: see above");
static_assert(sizeof(firmware::Term) == 32, "a field was added or removed: see above");

// A rig as large as the core: every field is in use.
ControllerConfiguration full() {
  ControllerConfiguration c = bench::driving();
  c.core.dof_count = firmware::kMaxDofs;
  c.core.link_count = firmware::kMaxLinks;
  c.core.term_count = firmware::kMaxTerms;
  c.core.unknown_count = firmware::kMaxUnknowns;
  c.core.base_present = true;
  c.programme.level_count = firmware::kMaxLevels;
  return c;
}

using Change = std::function<void(ControllerConfiguration&)>;

std::vector<Change> changes() {
  using C = ControllerConfiguration;
  return {
      [](C& c) { c.core.dof_count = 9; },
      [](C& c) { c.core.link_count = 9; },
      [](C& c) { c.core.term_count = 9; },
      [](C& c) { c.core.unknown_count = 9; },
      [](C& c) { c.core.base_present = false; },
      [](C& c) { c.core.sample_period_s = firmware::Scaled::ratio(1, 777); },
      [](C& c) { c.core.links[31].node_a = 5; },
      [](C& c) { c.core.links[31].node_b = 5; },
      [](C& c) { c.core.terms[95].kind = firmware::TermKind::kStribeck; },
      [](C& c) { c.core.terms[95].place = 7; },
      [](C& c) { c.core.terms[95].unknown = 7; },
      [](C& c) { c.core.terms[95].value.mantissa = -5; },
      [](C& c) { c.core.terms[95].shape.exponent = -5; },
      [](C& c) { c.core.channels[16][3].present = true; },
      [](C& c) { c.core.channels[16][3].offset_code = -77; },
      [](C& c) { c.core.channels[16][3].lowest_code = -77; },
      [](C& c) { c.core.channels[16][3].highest_code = 77; },
      [](C& c) { c.core.channels[16][3].unit_per_code.exponent = 3; },
      [](C& c) { c.core.channels[16][3].delay_ns = -250000; },
      [](C& c) { c.core.signals[16][3].available = true; },
      [](C& c) { c.core.signals[16][3].derived = true; },
      [](C& c) { c.core.signals[16][3].source = 2; },
      [](C& c) { c.core.signals[16][3].integrations = 2; },
      [](C& c) { c.core.signals[16][3].half_length = 4; },
      [](C& c) { c.core.signals[16][3].shift = 4; },
      [](C& c) { c.core.signals[16][3].tap[0].raw = -4; },
      [](C& c) { c.core.signals[16][3].unit_per_code.mantissa = 4; },
      [](C& c) { c.core.fusion[16].used = true; },
      [](C& c) { c.core.fusion[16].leak_shift = 7; },
      [](C& c) {
        c.core.fusion[16].used = true;
        c.core.fusion[16].step_tap[0].raw = 7;
      },
      [](C& c) {
        c.core.signals[16][2].derived = true;
        c.core.shared_noise[16][2][3].mantissa = 7;
      },
      [](C& c) { c.core.noise_unknown = true; },
      [](C& c) { c.core.shares_probe_noise = true; },
      [](C& c) {
        c.core.shares_probe_noise = true;
        c.core.probe_noise[16].motion[3][2].mantissa = 7;
      },
      [](C& c) {
        c.core.shares_probe_noise = true;
        c.core.probe_noise[16].force.mantissa = 7;
      },
      [](C& c) { c.core.sign_half_length = 5; },
      [](C& c) {
        c.core.sign_half_length = 12;
        c.core.sign_tap[24].raw = 7;
      },
      [](C& c) { c.core.high_pass_order = 2; },
      [](C& c) { c.core.high_pass_shift = 2; },
      [](C& c) { c.core.window.mode = firmware::WindowMode::kFreeDecay; },
      [](C& c) { c.core.window.cycle_samples_numerator = 100; },
      [](C& c) { c.core.window.cycle_samples_denominator = 3; },
      [](C& c) { c.core.window.batch_samples = 99; },
      [](C& c) { c.programme.level_count = 3; },
      [](C& c) { c.programme.start_at_boot = true; },
      [](C& c) { c.programme.limits.magnitude.raw = 5; },
      [](C& c) { c.programme.limits.step_per_sample.raw = 5; },
      [](C& c) { c.programme.levels[7].kind = firmware::ExcitationKind::kFreeDecay; },
      [](C& c) { c.programme.levels[7].amplitude.raw = 5; },
      [](C& c) { c.programme.levels[7].phase_step = 5; },
      [](C& c) { c.programme.levels[7].high_phase_step = 5; },
      [](C& c) { c.programme.levels[7].seed = 5; },
      [](C& c) { c.programme.levels[7].ramp_samples = 5; },
      [](C& c) { c.programme.levels[7].settle.block_samples = 5; },
      [](C& c) { c.programme.levels[7].settle.bound_per_mille = 5; },
      [](C& c) { c.programme.levels[7].settle.blocks = 5; },
      [](C& c) { c.programme.levels[7].settle.floor_code = 5; },
      [](C& c) { c.programme.levels[7].settle_limit_samples = 5; },
      [](C& c) { c.programme.levels[7].skip_when_unsettled = true; },
      [](C& c) { c.programme.levels[7].measure_samples = 5; },
      [](C& c) { c.limits.saturated_in_row = 9; },
      [](C& c) { c.limits.lost_in_row = 9; },
      [](C& c) { c.limits.sample_timeout_us = 9; },
      [](C& c) { c.limits.step_timeout_us = 9; },
      [](C& c) { c.limits.response_limit_code[16][3] = -9; },
      [](C& c) { c.node.node = 5; },
      [](C& c) { c.node.can_fd = true; },
      [](C& c) { c.node.float_estimates = firmware::FloatEstimates::kNever; },
      [](C& c) { c.node.sync_closes_window = false; },
      [](C& c) { c.node.drive_on_can = true; },
      [](C& c) { c.node.listen_on_command = true; },
      [](C& c) { c.node.heartbeat_ms = 5; },
      [](C& c) { c.node.status_ms = 5; },
      [](C& c) { c.node.emergency_inhibit_ms = 5; },
      [](C& c) { c.node.window_samples = 5; },
      [](C& c) { c.node.rotating_nodes = 5; },
  };
}

struct Encoded {
  uint8_t bytes[firmware::kConfigurationBytes] = {};
  size_t size = 0;
  explicit Encoded(const ControllerConfiguration& configuration) { size = encode(configuration, bytes); }
};

TEST(Configuration, EveryFieldIsInTheCheckSumAndComesBack) {
  const ControllerConfiguration original = full();
  int number = 0;
  for (const Change& change : changes()) {
    ControllerConfiguration changed = original;
    change(changed);
    EXPECT_NE(configuration_crc(changed), configuration_crc(original)) << "change " << number;
    const Encoded encoded(changed);
    ControllerConfiguration back = original;
    ASSERT_TRUE(decode(encoded.bytes, encoded.size, back)) << "change " << number;
    EXPECT_EQ(configuration_crc(back), configuration_crc(changed)) << "change " << number;
    ++number;
  }
}

TEST(Configuration, LargestOneFits) {
  ControllerConfiguration largest = full();
  for (auto& node : largest.core.signals)
    for (auto& signal : node) signal.half_length = firmware::kFilterHalf;
  EXPECT_LE(Encoded(largest).size, firmware::kConfigurationBytes);
}

// A core with room for fewer DOFs reads the same bytes: only what is in use is there, the base and the ground have numbers
// of their own. 11 bytes of version, counts and flags, then the sample period and the first link, DOF 1 to ground.
TEST(Configuration, NumbersOfNodesDoNotDependOnTheCapacity) {
  ControllerConfiguration configuration;
  configuration.core.dof_count = configuration.core.link_count = 1;
  configuration.core.links[0] = {0, firmware::kGroundNode};
  const Encoded encoded(configuration);
  constexpr size_t kLink = 4 + 5 + 2 + 12;
  EXPECT_EQ(encoded.bytes[kLink], 0);
  EXPECT_EQ(encoded.bytes[kLink + 1], 17);
  configuration.core.base_present = true;
  configuration.core.links[0].node_b = firmware::kBaseNode;
  EXPECT_EQ(Encoded(configuration).bytes[kLink + 1], 16);
  EXPECT_LT(encoded.size, 900u);  // one DOF of the core's 16
}

TEST(Configuration, WhatTheCoreHasNoRoomForIsRefused) {
  const auto decodes = [](const ControllerConfiguration& configuration) {
    ControllerConfiguration back;
    const Encoded encoded(configuration);
    return decode(encoded.bytes, encoded.size, back);
  };
  ControllerConfiguration configuration = bench::driving();
  EXPECT_TRUE(decodes(configuration));
  configuration.core.unknown_count = firmware::kMaxUnknowns + 1;
  EXPECT_FALSE(decodes(configuration));
}

TEST(Configuration, NodeSettingsAreNotTheRig) {
  ControllerConfiguration other = bench::driving();
  other.node.heartbeat_ms = 7;
  firmware::NodeConfiguration node;
  Encoded encoded(other);
  EXPECT_EQ(read_stored(encoded.bytes, encoded.size, bench::driving(), node), firmware::Stored::kOfThisRig);
  EXPECT_EQ(node.heartbeat_ms, 7);
  encoded.bytes[100] ^= 1;
  EXPECT_EQ(read_stored(encoded.bytes, encoded.size, bench::driving(), node), firmware::Stored::kDamaged);
  other.limits.lost_in_row = 7;
  other.node.heartbeat_ms = 9;
  const Encoded another(other);
  EXPECT_EQ(read_stored(another.bytes, another.size, bench::driving(), node), firmware::Stored::kOfAnotherRig);
  EXPECT_EQ(node.heartbeat_ms, 7);
}

TEST(Configuration, EveryFieldOfTheRigTellsItFromAnother) {
  const ControllerConfiguration original = full();
  for (const Change& change : changes()) {
    ControllerConfiguration changed = original;
    change(changed);
    const bool of_the_node = configuration_crc(changed) != configuration_crc(original) && [&] {
      ControllerConfiguration with_its_node = original;
      with_its_node.node = changed.node;
      return configuration_crc(with_its_node) == configuration_crc(changed);
    }();
    const Encoded encoded(changed);
    firmware::NodeConfiguration node;
    EXPECT_EQ(read_stored(encoded.bytes, encoded.size, original, node),
              of_the_node ? firmware::Stored::kOfThisRig : firmware::Stored::kOfAnotherRig);
  }
}

TEST(Configuration, DamageAndCutsAreRefusedAndLeaveTheTargetAlone) {
  const Encoded encoded(bench::driving());
  ControllerConfiguration target = bench::listening();
  const uint32_t before = configuration_crc(target);
  for (size_t place = 0; place < encoded.size; place += 37) {
    Encoded damaged = encoded;
    damaged.bytes[place] ^= 0x10;
    EXPECT_FALSE(decode(damaged.bytes, damaged.size, target)) << place;
  }
  for (size_t size : {size_t{0}, size_t{3}, size_t{7}, encoded.size / 2, encoded.size - 1}) {
    EXPECT_FALSE(decode(encoded.bytes, size, target)) << size;
  }
  EXPECT_EQ(configuration_crc(target), before);
}

TEST(Configuration, CheckSumIsTheWellKnownCrc32) {
  // CRC-32 over a message and its own little-endian CRC leaves the residue 0x2144DF1C, whatever the message.
  const Encoded encoded(bench::driving());
  uint32_t crc = 0xFFFFFFFFu;
  for (size_t i = 0; i < encoded.size; ++i) {
    crc ^= encoded.bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xEDB88320u : 0);
  }
  EXPECT_EQ(~crc, 0x2144DF1Cu);
}

}  // namespace

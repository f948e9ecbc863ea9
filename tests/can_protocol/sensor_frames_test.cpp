// Sensor frames by hand, and their joining to samples when frames are missing, late, repeated or out of order.
#include "firmware/can_protocol/streams/sensor_frames.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace firmware {
namespace {

std::string hex(const CanFrame& message) {
  char text[8];
  std::snprintf(text, sizeof text, "%03X#", message.id);
  std::string line = text;
  for (int i = 0; i < message.length; ++i) {
    std::snprintf(text, sizeof text, "%02X", message.data[i]);
    line += text;
  }
  return line;
}

void add(CoreConfiguration& configuration, int node, Quantity quantity) {
  configuration.channels[node][static_cast<int>(quantity)].present = true;
}

// Two DOFs: displacement and velocity on both, force and acceleration on the first.
CoreConfiguration two_dofs() {
  CoreConfiguration configuration;
  for (int node : {0, 1}) {
    add(configuration, node, Quantity::kDisplacement);
    add(configuration, node, Quantity::kVelocity);
  }
  add(configuration, 0, Quantity::kForce);
  add(configuration, 0, Quantity::kAcceleration);
  return configuration;
}

RawSample sample_of(uint32_t sequence) {
  RawSample sample;
  sample.sequence = sequence;
  const int32_t codes[2][kQuantities] = {{-8388608, 1, -1, 8388607}, {0, 0x123456, -2, 0}};
  for (int node : {0, 1})
    for (int q = 0; q < kQuantities; ++q) sample.code[node][q] = codes[node][q];
  return sample;
}

std::vector<CanFrame> frames_of(const SensorPlan& plan, const RawSample& sample) {
  CanFrame messages[kMaxSensorFrames];
  return std::vector<CanFrame>(messages, messages + pack_sample(plan, sample, messages));
}

TEST(SensorFrames, ByHand) {
  // Sequence 0x12345: 45 23. 24 bits, DOF 1: x = 1, v = -1; f = -2^23 = 00 00 80, a = FF FF 7F. DOF 2: x = 56 34 12, v
  // = -2.
  std::vector<CanFrame> frames = frames_of(sensor_plan(two_dofs(), SensorWiring::k24), sample_of(0x12345));
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(hex(frames[0]), "1C1#4523010000FFFFFF");
  EXPECT_EQ(hex(frames[1]), "1E1#4523000080FFFF7F");
  EXPECT_EQ(hex(frames[2]), "1C2#4523563412FEFFFF");

  // 16 bits: a and x beyond 16 bits are clamped to 0x7FFF; the force has 24 bits here too.
  frames = frames_of(sensor_plan(two_dofs(), SensorWiring::k16), sample_of(0x12345));
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(hex(frames[0]), "1A1#45230100FFFFFF7F");
  EXPECT_EQ(hex(frames[1]), "221#4523000080");
  EXPECT_EQ(hex(frames[2]), "1A2#4523FF7FFEFF0000");

  // CAN FD: whole sequence, then f, x, v, a.
  frames = frames_of(sensor_plan(two_dofs(), SensorWiring::kFd), sample_of(0x12345));
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_TRUE(frames[0].fd);
  EXPECT_EQ(hex(frames[0]), "241#45230100000080010000FFFFFFFFFF7F");
}

// Six channels two by two, by DOF and then by quantity: f1 x1 | v1 a1 | x2 v2. 24 bits: f1 = -2^23 = 00 00 80, x1 = 1,
// v1 = -1, a1 = FF FF 7F, x2 = 56 34 12, v2 = -2.
TEST(SensorFrames, PairsByHand) {
  const SensorPlan plan = sensor_plan(two_dofs(), SensorWiring::kPairs);
  EXPECT_EQ(sensor_frames_per_sample(plan), 3);
  const std::vector<CanFrame> frames = frames_of(plan, sample_of(0x12345));
  ASSERT_EQ(frames.size(), 3u);
  EXPECT_EQ(hex(frames[0]), "261#4523000080010000");
  EXPECT_EQ(hex(frames[1]), "262#4523FFFFFFFFFF7F");
  EXPECT_EQ(hex(frames[2]), "263#4523563412FEFFFF");
  SensorAssembler assembler(plan);
  RawSample out;
  EXPECT_FALSE(assembler.push(frames[2], 1, out));
  EXPECT_FALSE(assembler.push(frames[0], 2, out));
  ASSERT_TRUE(assembler.push(frames[1], 3, out));
  for (int node : {0, 1})
    for (int q = 0; q < kQuantities; ++q) EXPECT_EQ(out.code[node][q], sample_of(0).code[node][q]) << node << " " << q;
}

// An odd number of channels leaves the last place empty; more channels than frames can carry make no plan at all.
TEST(SensorFrames, PairsOfAnOddNumberAndOfTooMany) {
  CoreConfiguration configuration;
  add(configuration, 1, Quantity::kVelocity);
  add(configuration, 4, Quantity::kForce);
  add(configuration, kBaseNode, Quantity::kAcceleration);
  RawSample sample;
  sample.code[kBaseNode][3] = 5;
  const SensorPlan plan = sensor_plan(configuration, SensorWiring::kPairs);
  const std::vector<CanFrame> frames = frames_of(plan, sample);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(hex(frames[1]), "262#0000050000000000");
  for (int node = 0; node < kMaxNodes; ++node)
    for (int q = 1; q < kQuantities; ++q) add(configuration, node, static_cast<Quantity>(q));
  EXPECT_EQ(sensor_frames_per_sample(sensor_plan(configuration, SensorWiring::kPairs)), 0);
}

TEST(SensorFrames, TheBaseHasNumber17) {
  CoreConfiguration configuration;
  add(configuration, kBaseNode, Quantity::kAcceleration);
  RawSample sample;
  sample.code[kBaseNode][3] = 5;
  const std::vector<CanFrame> frames = frames_of(sensor_plan(configuration, SensorWiring::k24), sample);
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(hex(frames[0]), "1F1#0000000000050000");
}

class Assembly : public ::testing::Test {
 protected:
  Assembly() : plan_(sensor_plan(two_dofs(), SensorWiring::k24)), assembler_(plan_) {}
  // Sends frame number `which` of a sample; returns whether a sample came out.
  bool send(uint32_t sequence, int which, uint64_t time_ns = 0) {
    return assembler_.push(frames_of(plan_, sample_of(sequence))[static_cast<size_t>(which)], time_ns, out_);
  }
  bool send_all(uint32_t sequence) {
    bool complete = false;
    for (int which : {0, 1, 2}) complete = send(sequence, which) || complete;
    return complete;
  }
  SensorPlan plan_;
  SensorAssembler assembler_;
  RawSample out_;
};

TEST_F(Assembly, JoinsAllFramesOfASampleInAnyOrder) {
  EXPECT_FALSE(send(7, 2, 100));
  EXPECT_FALSE(send(7, 0, 200));
  EXPECT_TRUE(send(7, 1, 300));
  EXPECT_EQ(out_.sequence, 7u);
  EXPECT_EQ(out_.time_ns, 100u);  // of its first frame
  const RawSample expected = sample_of(7);
  for (int node = 0; node < kMaxNodes; ++node)
    for (int q = 0; q < kQuantities; ++q) EXPECT_EQ(out_.code[node][q], expected.code[node][q]) << node << " " << q;
  EXPECT_EQ(assembler_.health().samples, 1u);
}

TEST_F(Assembly, TheSequenceCountsOnBeyond16Bits) {
  for (uint32_t sequence = 65530; sequence < 65536 + 70000; ++sequence) {
    ASSERT_TRUE(send_all(sequence));
    ASSERT_EQ(out_.sequence, sequence);
  }
  EXPECT_EQ(assembler_.health().lost_samples, 0u);
}

TEST_F(Assembly, ALostFrameLosesItsSampleAndNoOther) {
  EXPECT_TRUE(send_all(10));
  EXPECT_FALSE(send(11, 0));
  EXPECT_FALSE(send(11, 2));  // frame 1 (DOF 1, force) never comes
  EXPECT_TRUE(send_all(12));
  EXPECT_EQ(out_.sequence, 12u);
  EXPECT_EQ(assembler_.health().lost_samples, 1u);
  EXPECT_EQ(assembler_.health().lost_frames, 1u);
  EXPECT_EQ(assembler_.health().last_lost_node, 0);
  EXPECT_FALSE(send(11, 1));  // now it comes, too late
  EXPECT_EQ(assembler_.health().late_frames, 1u);
  EXPECT_EQ(assembler_.health().samples, 2u);
}

TEST_F(Assembly, ASensorMayLagThreeSamples) {
  for (uint32_t sequence = 100; sequence < 200; ++sequence) {
    send(sequence, 0);
    send(sequence, 1);
    if (sequence < 103) continue;
    ASSERT_TRUE(send(sequence - 3, 2)) << sequence;  // DOF 2 comes three samples late
    ASSERT_EQ(out_.sequence, sequence - 3);
  }
  EXPECT_EQ(assembler_.health().lost_samples, 0u);
}

TEST_F(Assembly, ASensorThatFallsSilentLosesEverySample) {
  for (uint32_t sequence = 0; sequence < 50; ++sequence) {
    EXPECT_FALSE(send(sequence, 0));
    EXPECT_FALSE(send(sequence, 1));
  }
  // Four samples are still open; the other 46 are given up, each for one frame, of DOF 2.
  EXPECT_EQ(assembler_.health().lost_samples, 46u);
  EXPECT_EQ(assembler_.health().lost_frames, 46u);
  EXPECT_EQ(assembler_.health().last_lost_node, 1);
  EXPECT_EQ(assembler_.health().samples, 0u);
}

TEST_F(Assembly, RepeatedFramesAndOtherFramesAreNotUsed) {
  EXPECT_FALSE(send(5, 0));
  EXPECT_FALSE(send(5, 0));
  EXPECT_EQ(assembler_.health().repeated_frames, 1u);
  CanFrame other;
  other.id = 0x1C3;  // a DOF that the plan does not have
  other.length = 8;
  EXPECT_FALSE(assembler_.push(other, 0, out_));
  other.id = 0x1A1;  // the 16-bit frame of DOF 1: not its wiring
  EXPECT_FALSE(assembler_.push(other, 0, out_));
  EXPECT_FALSE(send(5, 1));
  EXPECT_TRUE(send(5, 2));
}

TEST_F(Assembly, ARestartedSensorStartsTheCountAnew) {
  EXPECT_TRUE(send_all(30000));
  EXPECT_FALSE(send(0, 0));
  EXPECT_EQ(assembler_.health().restarts, 1u);
  EXPECT_FALSE(send(0, 1));
  EXPECT_TRUE(send(0, 2));
  EXPECT_EQ(out_.sequence, 0u);
  assembler_.reset();
  EXPECT_EQ(assembler_.health().samples, 0u);
  EXPECT_TRUE(send_all(9));
}

}  // namespace
}  // namespace firmware

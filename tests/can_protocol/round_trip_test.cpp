// Every struct through its frame and back, and every unpack function against frames that are not its own.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "firmware/can_protocol/streams/sensor_frames.hpp"

namespace firmware {
namespace {

TEST(RoundTrip, EveryStruct) {
  int node = 0;
  HeartbeatState state = HeartbeatState::kBootUp;
  ASSERT_TRUE(unpack_heartbeat(pack_heartbeat(5, HeartbeatState::kPreOperational), node, state));
  EXPECT_EQ(node, 5);
  EXPECT_EQ(state, HeartbeatState::kPreOperational);

  Emergency emergency;
  ASSERT_TRUE(
      unpack_emergency(pack_emergency(4, {EmergencyCode::kSensorLost, 0x91, 17, 3, 0xFFFFFFFFu}), node, emergency));
  EXPECT_EQ(node, 4);
  EXPECT_EQ(emergency.code, EmergencyCode::kSensorLost);
  EXPECT_EQ(emergency.error_register, 0x91);
  EXPECT_EQ(emergency.place, 17);
  EXPECT_EQ(emergency.quantity, 3);
  EXPECT_EQ(emergency.detail, 0xFFFFFFFFu);

  NodeStatus status;
  ASSERT_TRUE(unpack_status(
      pack_status(1, {0xFFFF, ControllerMode::kFault, EstimateStatus::kSaturated, 255, 0x80000000u}), node, status));
  EXPECT_EQ(status.faults, 0xFFFF);
  EXPECT_EQ(status.mode, ControllerMode::kFault);
  EXPECT_EQ(status.quality, EstimateStatus::kSaturated);
  EXPECT_EQ(status.condition_log2, 255);
  EXPECT_EQ(status.update_counter, 0x80000000u);

  NodeHealth health, health_in;
  health_in.uptime_s = 86400;
  health_in.core.missed_samples = 3;
  health_in.core.saturated_samples = 65535;
  health_in.bus_off = 10;
  ASSERT_TRUE(unpack_health(pack_health(2, health_in), node, health));
  EXPECT_EQ(health.uptime_s, 86400u);
  EXPECT_EQ(health.core.missed_samples, 3u);
  EXPECT_EQ(health.core.saturated_samples, 65535u);
  EXPECT_EQ(health.bus_off, 10u);

  BusHealth bus;
  ASSERT_TRUE(unpack_bus_health(pack_bus_health(2, {1, 2, 3, 4, 5, 600}), node, bus));
  EXPECT_EQ(std::vector<uint32_t>({bus.restarts, bus.error_passive, bus.controller_overflow, bus.interface_down,
                                   bus.frames_not_sent, bus.sensor_frames_lost}),
            std::vector<uint32_t>({1, 2, 3, 4, 5, 600}));

  Identity identity;
  ASSERT_TRUE(unpack_identity(pack_identity(3, {1, 2, 3, 48, 0x12345678}), node, identity));
  EXPECT_EQ(identity.version_patch, 3);
  EXPECT_EQ(identity.parameters, 48);
  EXPECT_EQ(identity.configuration_crc, 0x12345678u);

  WindowResult window;
  ASSERT_TRUE(unpack_window(pack_window(3, {4294967295u, 70000, 70000}), node, window));
  EXPECT_EQ(window.residual_e9, 4294967295u);
  EXPECT_EQ(window.equations, 65535u);
  EXPECT_EQ(window.window, 70000u - 65536u);

  Diagnosis diagnosis;
  Diagnosis found;
  found.cause = Cause::kUnknown;
  found.place_a = 1;
  found.place_b = 17;
  found.unexplained_permille = 1000;
  found.gained_permille = 999;
  found.size = {-123456789, 65535, -24, 15};
  found.corrected = true;
  found.rival = Cause::kAmbiguous;
  found.rival_place_a = 16;
  found.rival_quantity = 3;
  found.rival_permille = 65535;
  ASSERT_TRUE(unpack_diagnosis(pack_diagnosis(3, found), node, diagnosis));
  ASSERT_TRUE(unpack_diagnosis_size(pack_diagnosis_size(3, found), node, diagnosis));
  ASSERT_TRUE(unpack_diagnosis_rival(pack_diagnosis_rival(3, found), node, diagnosis));
  EXPECT_EQ(diagnosis.size.value, -123456789);
  EXPECT_EQ(diagnosis.size.std, 65535);
  EXPECT_EQ(diagnosis.size.exponent, -24);
  EXPECT_EQ(diagnosis.size.std_exponent, 15);
  EXPECT_TRUE(diagnosis.corrected);
  EXPECT_EQ(diagnosis.rival, Cause::kAmbiguous);
  EXPECT_EQ(diagnosis.rival_place_a, 16);
  EXPECT_EQ(diagnosis.rival_place_b, 31);
  EXPECT_EQ(diagnosis.rival_quantity, 3);
  EXPECT_EQ(diagnosis.rival_permille, 65535);
  EXPECT_EQ(diagnosis.cause, Cause::kUnknown);
  EXPECT_EQ(diagnosis.place_b, 17);
  EXPECT_EQ(diagnosis.unexplained_permille, 1000);
  EXPECT_EQ(diagnosis.gained_permille, 999);

  ParameterDescription parameter;
  ASSERT_TRUE(unpack_parameter(pack_parameter(6, {47, 48, TermKind::kDriftingViscous, 16, 0, true}), node, parameter));
  EXPECT_EQ(parameter.index, 47);
  EXPECT_EQ(parameter.kind, TermKind::kDriftingViscous);
  EXPECT_EQ(parameter.place_a, 16);
  EXPECT_EQ(parameter.place_b, 0);
  EXPECT_TRUE(parameter.rotating);

  ChannelScaling scaling;
  ASSERT_TRUE(unpack_scaling(pack_scaling(6, {17, Quantity::kVelocity, true, -18, -2147483647, -250}), node, scaling));
  EXPECT_EQ(scaling.place, 17);
  EXPECT_EQ(scaling.quantity, Quantity::kVelocity);
  EXPECT_TRUE(scaling.rotating);
  EXPECT_EQ(scaling.exponent, -18);
  EXPECT_EQ(scaling.unit_per_code, -2147483647);
  EXPECT_EQ(scaling.delay_us, -250);

  ChannelRange range;
  ASSERT_TRUE(unpack_range(pack_range(6, {2, Quantity::kForce, false, -8388608, 8388607}), node, range));
  EXPECT_EQ(range.offset_code, -8388608);
  EXPECT_EQ(range.full_scale_code, 8388607);
  // The middle of offset binary is one more than 24 bits with sign hold.
  ASSERT_TRUE(unpack_range(pack_range(6, {2, Quantity::kForce, false, 8388608, 8388607}), node, range));
  EXPECT_EQ(range.offset_code, 8388607);

  DriveCommand drive;
  ASSERT_TRUE(unpack_drive(pack_drive(7, {INT32_MIN, 0x1FFFF, DriveState::kStopped}), node, drive));
  EXPECT_EQ(node, 7);
  EXPECT_EQ(drive.drive_q31, INT32_MIN);
  EXPECT_EQ(drive.sequence, 0xFFFFu);
  EXPECT_EQ(drive.state, DriveState::kStopped);
  EXPECT_TRUE(is_sync(pack_sync()));

  NetworkCommand command;
  ASSERT_TRUE(unpack_network_command(pack_network_command({NetworkCommandCode::kReset, 5}), command));
  EXPECT_EQ(command.command, NetworkCommandCode::kReset);
  EXPECT_EQ(command.node, 5);
}

// Each frame is taken by exactly one unpack function.
int takers(const CanFrame& m) {
  int node = 0, index = 0, count = 0;
  HeartbeatState a;
  Emergency b;
  NodeStatus c;
  NodeHealth d;
  BusHealth e;
  Identity f;
  WindowResult g;
  Diagnosis h;
  ParameterDescription i;
  ChannelScaling j;
  ChannelRange k;
  DriveCommand l;
  NetworkCommand n;
  EstimateRecord record, records[kEstimatesPerFdFrame];
  bool present[kEstimatesPerFdFrame];
  count += unpack_heartbeat(m, node, a) + unpack_emergency(m, node, b) + unpack_status(m, node, c) +
           unpack_health(m, node, d) + unpack_bus_health(m, node, e) + unpack_identity(m, node, f) +
           unpack_window(m, node, g) + unpack_diagnosis(m, node, h) + unpack_diagnosis_size(m, node, h) +
           unpack_diagnosis_rival(m, node, h) + unpack_parameter(m, node, i) + unpack_scaling(m, node, j) +
           unpack_range(m, node, k) + unpack_drive(m, node, l) + is_sync(m) + unpack_network_command(m, n) +
           unpack_estimate(m, node, index, record) + unpack_estimates_fd(m, node, index, records, present);
  return count;
}

TEST(RoundTrip, OneUnpackFunctionPerFrame) {
  for (const can::FrameDescription* frame : can::kFrames) {
    const bool others = frame->sender == can::Sender::kSensor || frame == &can::kSdoRequest ||
                        frame == &can::kSdoReply || frame == &can::kEstimateFloat || frame == &can::kEstimateFloatFd;
    EXPECT_EQ(takers(can::empty_frame(*frame, 1)), others ? 0 : 1) << frame->name;
  }
}

// Whatever arrives, nothing is read or written outside (this test is for the sanitizers).
TEST(RoundTrip, RandomFramesAreSurvived) {
  std::mt19937_64 random(2);
  CoreConfiguration configuration;
  for (auto& node : configuration.channels)
    for (ChannelConfiguration& channel : node) channel.present = true;
  SensorAssembler assemblers[] = {SensorAssembler(sensor_plan(configuration, SensorWiring::k16)),
                                  SensorAssembler(sensor_plan(configuration, SensorWiring::k24)),
                                  SensorAssembler(sensor_plan(configuration, SensorWiring::kFd))};
  int taken = 0;
  for (int round = 0; round < 200000; ++round) {
    CanFrame message;
    message.id = static_cast<uint32_t>(random() % 0x900);
    message.fd = random() % 4 == 0;
    message.extended = random() % 16 == 0;
    message.length = static_cast<uint8_t>(random() % (message.fd ? 65 : 9));
    for (uint8_t& byte : message.data) byte = static_cast<uint8_t>(random());
    taken += takers(message);
    RawSample sample;
    for (SensorAssembler& assembler : assemblers) assembler.push(message, static_cast<uint64_t>(round), sample);
  }
  EXPECT_GT(taken, 1000);
}

}  // namespace
}  // namespace firmware

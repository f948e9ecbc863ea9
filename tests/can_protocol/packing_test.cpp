// Frames by hand: identifiers and bytes are worked out in the comments, from docs/can_protocol.md.
#include "firmware/can_protocol/messages/packing.hpp"

#include <gtest/gtest.h>

#include <string>

#include "firmware/can_protocol/streams/estimate_frames.hpp"

namespace firmware {
namespace {

std::string hex(const CanFrame& message) {
  static const char kDigits[] = "0123456789ABCDEF";
  std::string text;
  for (int i = 2; i >= 0; --i) text += kDigits[message.id >> (4 * i) & 15];
  text += '#';
  for (int i = 0; i < message.length; ++i) {
    text += kDigits[message.data[i] >> 4];
    text += kDigits[message.data[i] & 15];
  }
  return text;
}

TEST(Packing, FramesOfTheController) {
  // 0x700 + 3; one byte, operational = 5.
  EXPECT_EQ(hex(pack_heartbeat(3, HeartbeatState::kOperational)), "703#05");
  EXPECT_EQ(hex(pack_heartbeat(1, HeartbeatState::kBootUp)), "701#00");
  EXPECT_EQ(hex(pack_sync()), "080#");

  // 0x180 + 7. faults: bit 0 + bit 4 = 0x0011; mode 4 and quality 4 share a byte: 0x44; condition 0x0A; counter
  // 0x01020304.
  NodeStatus status;
  status.faults = static_cast<uint16_t>(fault_bit(Fault::kEmergencyStop) | fault_bit(Fault::kDriveLimit));
  status.mode = ControllerMode::kIntegrate;
  status.quality = EstimateStatus::kIllConditioned;
  status.condition_log2 = 10;
  status.update_counter = 0x01020304;
  EXPECT_EQ(hex(pack_status(7, status)), "187#1100440A04030201");

  // 0x080 + 2. code 0xFF02; register 0x11; place 3 with quantity 2 above its 5 bits: 3 + 2 * 32 = 0x43; detail 1000 =
  // 0x3E8.
  Emergency emergency;
  emergency.code = EmergencyCode::kSensorSaturated;
  emergency.error_register = 0x11;
  emergency.place = 3;
  emergency.quantity = 2;
  emergency.detail = 1000;
  EXPECT_EQ(hex(pack_emergency(2, emergency)), "082#02FF1143E8030000");

  // 0x480 + 1. cause 20 = 0x14; place 2; no second place 31 = 0x1F; quantity 1; 999 = 0x3E7; 12 = 0x0C.
  Diagnosis diagnosis;
  diagnosis.cause = static_cast<Cause>(20);
  diagnosis.place_a = 2;
  diagnosis.quantity = 1;
  diagnosis.unexplained_permille = 999;
  diagnosis.gained_permille = 12;
  EXPECT_EQ(hex(pack_diagnosis(1, diagnosis)), "481#14021F01E7030C00");

  // 0x380 + 1. version 1.2.3, 5 parameters, CRC 0xCAFEBABE little-endian.
  EXPECT_EQ(hex(pack_identity(1, {1, 2, 3, 5, 0xCAFEBABEu})), "381#01020305BEBAFECA");

  // 0x390 + 1. residual 1.11e-3 = 1110000e-9 = 0x0010EFF0; 96 equations = 0x60; window 65537 modulo 65536 = 1.
  EXPECT_EQ(hex(pack_window(1, {1110000, 96, 65537})), "391#F0EF100060000100");

  // 0x200 + 1. half of full scale down: -2^30 = 0xC0000000; sequence 0x12345 modulo 65536 = 0x2345; enabled.
  EXPECT_EQ(hex(pack_drive(1, {-(1 << 30), 0x12345, DriveState::kEnabled})), "201#000000C0452301");
}

TEST(Packing, CountersStayAtTheLargestValueOfTheirSignal) {
  // 24 bits of uptime, 16 of each sample counter, 8 of bus-off: all at their largest.
  NodeHealth health;
  health.uptime_s = 0x01000000;
  health.core.missed_samples = 65536;
  health.core.saturated_samples = 4000000000u;
  health.bus_off = 256;
  EXPECT_EQ(hex(pack_health(1, health)), "281#FFFFFFFFFFFFFFFF");
  // One below the limits: FE FF FF | FE FF | FE FF | FE.
  health.uptime_s = 0xFFFFFE;
  health.core.missed_samples = 65534;
  health.core.saturated_samples = 65534;
  health.bus_off = 254;
  EXPECT_EQ(hex(pack_health(1, health)), "281#FEFFFFFEFFFEFFFE");
}

TEST(Packing, NamesAndScaling) {
  // 0x680 + 1. index 2 of 5, viscous = 2, link from DOF 1 to DOF 2, translation.
  ParameterDescription parameter;
  parameter.index = 2;
  parameter.count = 5;
  parameter.kind = TermKind::kViscous;
  parameter.place_a = 1;
  parameter.place_b = 2;
  EXPECT_EQ(hex(pack_parameter(1, parameter)), "681#020502010200");

  // 0x690 + 1. place 17 (base), quantity 3, translation: 17 + 3 * 32 = 0x71. 1.5e-9 per code: 10 digits at the most in
  // 31 bits, so 1500000000e-18: exponent -18 = 0xEE, mantissa 0x59682F00. Delay 250 us = 0xFA.
  ChannelConfiguration channel;
  channel.unit_per_code = Scaled::ratio(3, 2000000000);
  channel.delay_ns = 250999;
  EXPECT_EQ(hex(pack_scaling(1, channel_scaling(channel, kBaseNode, Quantity::kAcceleration, false))),
            "691#71EE002F6859FA00");

  // 0x6A0 + 1. DOF 1, quantity 1, rotation: 1 + 32 + 128 = 0xA1; offset -2 = 0xFFFFFE; full scale 2047 = 0x7FF.
  channel.offset_code = -2;
  channel.lowest_code = -2047;
  channel.highest_code = 2046;
  EXPECT_EQ(hex(pack_range(1, channel_range(channel, 0, Quantity::kDisplacement, true))), "6A1#A1FEFFFFFF0700");
}

TEST(EstimateFrames, ByHand) {
  // viscous 20.0012 +- 0.0123, window 7, VALID. 20.0012 = 2000120000e-8 (2000120000 < 2^31, one digit more is not):
  // 2000120000 = 0x773768C0. std in units of 10^-8: 1230000 > 65535, in 10^-6: 12300 = 0x300C, two above -8.
  // exponent field -8 + 24 = 16 = 0x10, status 0 above its 5 bits; last byte: std exponent 2, window 7 above: 0x72.
  ParameterEstimate estimate;
  estimate.value = Scaled::ratio(200012, 10000);
  estimate.std = Scaled::ratio(123, 10000);
  estimate.status = EstimateStatus::kValid;
  EXPECT_EQ(hex(pack_estimate(1, 0, estimate, 7)), "410#C06837770C301072");

  // -1e9 exactly, std 0, ILL_CONDITIONED (4), window 16 -> 0: -1000000000e0 = 0xC4653600; exponent 24 + 4 * 32 = 0x98.
  estimate.value = Scaled::from_int(-1000000000);
  estimate.std = Scaled();
  estimate.status = EstimateStatus::kIllConditioned;
  EXPECT_EQ(hex(pack_estimate(7, 47, estimate, 16)), "57F#003665C400009800");
}

// Where nothing explains it the cause is UNKNOWN, and the nearest stands in the rival's frame. Causes by their numbers on the bus.
TEST(Diagnosis, ACauseThatDoesNotExplainIsUnknown) {
  Estimates estimates;
  Warrant& warrant = estimates.warrant;
  warrant.tested = true;
  warrant.named.cause = cause_of(EffectKind::kStiffnessError);  // 3
  warrant.named.node_a = 1;
  warrant.named.node_b = 0;
  warrant.rival.cause = cause_of(EffectKind::kMassError);  // 16
  warrant.rival.node_a = 1;
  warrant.rival_share = Scaled::ratio(1, 4);
  warrant.gained = Scaled::ratio(35, 100);
  // cause 3 at 2-1, no channel (7); 0 unexplained, 350 = 0x015E taken away. The rival: 16 = 0x10 at DOF 2, 250 = 0x00FA.
  EXPECT_EQ(hex(pack_diagnosis(1, diagnosis_of(estimates))), "481#0302010700005E01");
  EXPECT_EQ(hex(pack_diagnosis_rival(1, diagnosis_of(estimates))), "3B1#10021F07FA00");
  warrant.naming = Naming::kInPart;
  EXPECT_EQ(hex(pack_diagnosis(1, diagnosis_of(estimates))), "481#FF02010700005E01");
  EXPECT_EQ(hex(pack_diagnosis_rival(1, diagnosis_of(estimates))), "3B1#03020107E803");  // 1000
  warrant.named = {};
  EXPECT_EQ(diagnosis_of(estimates).cause, Cause::kNone);
}

}  // namespace
}  // namespace firmware

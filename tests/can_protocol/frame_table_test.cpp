// The table as a whole: every identifier leads back to its frame, every signal keeps to its bits, names agree with the
// enums.
#include "firmware/can_protocol/frame_table.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "firmware/can_protocol/frame_plan_check.hpp"
#include "firmware/can_protocol/messages/packing.hpp"

namespace firmware {
namespace can {
namespace {

TEST(FrameTable, IdentifiersOfTheNotes) {
  for (int n = 1; n <= 7; ++n) {
    EXPECT_EQ(frame_id(kEmergency.ids, n), 0x080u + n);
    EXPECT_EQ(frame_id(kStatus.ids, n), 0x180u + n);
    EXPECT_EQ(frame_id(kHealth.ids, n), 0x280u + n);
    EXPECT_EQ(frame_id(kIdentity.ids, n), 0x380u + n);
    EXPECT_EQ(frame_id(kDiagnosis.ids, n), 0x480u + n);
    EXPECT_EQ(frame_id(kSdoReply.ids, n), 0x580u + n);
    EXPECT_EQ(frame_id(kSdoRequest.ids, n), 0x600u + n);
    EXPECT_EQ(frame_id(kHeartbeat.ids, n), 0x700u + n);
    for (int k = 0; k < 16; ++k) EXPECT_EQ(frame_id(kEstimate.ids, n, k), 0x400u + 16 * n + k);
  }
  // Node 2, estimate 16: second bank, 0x480 + 32; estimate 47: third bank, 0x500 + 32 + 15.
  EXPECT_EQ(frame_id(kEstimate.ids, 2, 16), 0x4A0u);
  EXPECT_EQ(frame_id(kEstimate.ids, 2, 47), 0x52Fu);
  // The float forms: 0x580, 0x600 and 0x700 + 16 n; node 2, estimate 47: 0x700 + 32 + 15.
  EXPECT_EQ(frame_id(kEstimateFloat.ids, 1, 0), 0x590u);
  EXPECT_EQ(frame_id(kEstimateFloat.ids, 7, 16), 0x670u);
  EXPECT_EQ(frame_id(kEstimateFloat.ids, 2, 47), 0x72Fu);
  // Other CANopen devices keep node numbers 8 to 15: none of their predefined identifiers is used.
  for (const uint32_t base : {0x080, 0x180, 0x200, 0x280, 0x300, 0x380, 0x400, 0x480, 0x500, 0x580, 0x600, 0x700}) {
    for (uint32_t n = 8; n <= 15; ++n) {
      for (const bool fd : {false, true}) {
        CanFrame message;
        message.id = base + n;
        message.fd = fd;
        message.length = fd ? 64 : 8;
        EXPECT_EQ(identify(message).frame, nullptr) << std::hex << message.id;
      }
    }
  }
  EXPECT_EQ(frame_id(kSensorMotion24.ids, 0, kBaseNode), 0x1C0u + 17);
}

TEST(FrameTable, EveryIdentifierLeadsBackToItsFrame) {
  std::set<uint32_t> used;
  for (const FrameDescription* frame : kFrames) {
    const bool per_node = frame->ids.node_stride > 0;
    for (int node = per_node ? 1 : 0; node <= (per_node ? 7 : 0); ++node) {
      for (int member = 0; member < frame->ids.members; ++member) {
        const CanFrame message = empty_frame(*frame, node, member);
        EXPECT_TRUE(used.insert(message.id).second) << message.id << " twice, now " << frame->name;
        const Address address = identify(message);
        EXPECT_EQ(address.frame, frame) << message.id;
        EXPECT_EQ(address.node, node);
        EXPECT_EQ(address.member, member);
      }
    }
  }
  for (uint32_t id = 0; id < 0x800; ++id) {
    for (bool fd : {false, true}) {
      CanFrame message;
      message.id = id;
      message.fd = fd;
      message.length = 64;
      EXPECT_EQ(identify(message).frame != nullptr && used.count(id) == 0, false) << id;
      message.extended = true;
      EXPECT_EQ(identify(message).frame, nullptr) << id;
    }
  }
}

// Other CANopen devices may have the nodes 8 to 15: what their predefined set uses is none of ours.
TEST(FrameTable, LeavesRoomForOtherCanopenNodes) {
  for (uint32_t function : {0x080, 0x180, 0x200, 0x280, 0x300, 0x380, 0x400, 0x480, 0x500, 0x580, 0x600, 0x700}) {
    for (uint32_t node = 8; node <= 15; ++node) {
      for (bool fd : {false, true}) {
        CanFrame message;
        message.id = function + node;
        message.fd = fd;
        message.length = 64;
        EXPECT_EQ(identify(message).frame, nullptr) << std::hex << message.id;
      }
    }
  }
}

TEST(FrameTable, AShortFrameOrTheOtherKindOfFrameIsNotTaken) {
  for (const FrameDescription* frame : kFrames) {
    CanFrame message = empty_frame(*frame, 1);
    message.fd = !message.fd;
    EXPECT_NE(identify(message).frame, frame) << frame->name;
    message.fd = !message.fd;
    if (frame->length == 0) continue;
    --message.length;
    EXPECT_EQ(identify(message).frame, nullptr) << frame->name;
  }
}

// Random values in all signals come back, whatever stands in the other signals and in the bits between them.
TEST(FrameTable, SignalsDoNotDisturbEachOther) {
  std::mt19937_64 random(1);
  for (const FrameDescription* frame : kFrames) {
    for (int round = 0; round < 200; ++round) {
      CanFrame message = empty_frame(*frame, 1);
      for (uint8_t& byte : message.data) byte = static_cast<uint8_t>(random());
      std::vector<int64_t> expected;
      for (int record = 0; record < frame->repeats; ++record) {
        for (int i = 0; i < frame->signal_count; ++i) {
          const Signal& signal = frame->signals[i];
          const int64_t span = highest_raw(signal) - lowest_raw(signal) + 1;
          expected.push_back(lowest_raw(signal) + static_cast<int64_t>(random() % static_cast<uint64_t>(span)));
          set_raw(message, signal, expected.back(), record * record_bits(*frame));
        }
      }
      size_t next = 0;
      for (int record = 0; record < frame->repeats; ++record)
        for (int i = 0; i < frame->signal_count; ++i)
          EXPECT_EQ(get_raw(message, frame->signals[i], record * record_bits(*frame)), expected[next++])
              << frame->name << "." << frame->signals[i].name;
    }
  }
}

TEST(FrameTable, ValuesOutsideASignalAreClamped) {
  const Signal wide = {"x", 0, 24, true, 1, 1, 0, "1", {}, ""};
  CanFrame message;
  set_raw(message, wide, 8388608);
  EXPECT_EQ(get_raw(message, wide), 8388607);
  set_raw(message, wide, -8388609);
  EXPECT_EQ(get_raw(message, wide), -8388608);
  const Signal narrow = {"x", 3, 5, false, 1, 1, 0, "1", {}, ""};
  set_raw(message, narrow, -1);
  EXPECT_EQ(get_raw(message, narrow), 0);
  set_raw(message, narrow, 32);
  EXPECT_EQ(get_raw(message, narrow), 31);
}

TEST(FrameTable, TheCheckSeesCollisionsAndOverlaps) {
  // 0x480 + n against estimates laid 48 in a row: estimate 16 of node 7 would be 0x400 + 112 + 16 = 0x480, of node 6
  // from 0x460 on.
  constexpr FrameDescription in_a_row = {"x", {0x400, 16, 48}, Sender::kController, 0, "", 8, false, 1, nullptr, 0, ""};
  const FrameDescription* colliding[] = {&kDiagnosis, &in_a_row};
  EXPECT_FALSE(ids_do_not_collide(colliding));
  const FrameDescription* good[] = {&kDiagnosis, &kEstimate};
  EXPECT_TRUE(ids_do_not_collide(good));

  const Signal overlapping[] = {{"a", 0, 9, false, 1, 1, 0, "1", {}, ""}, {"b", 8, 8, false, 1, 1, 0, "1", {}, ""}};
  EXPECT_FALSE(signals_fit({"x", {0}, Sender::kController, 0, "", 8, false, 1, overlapping, 2, ""}));
  const Signal outside[] = {{"a", 57, 8, false, 1, 1, 0, "1", {}, ""}};
  EXPECT_FALSE(signals_fit({"x", {0}, Sender::kController, 0, "", 8, false, 1, outside, 1, ""}));
  EXPECT_FALSE(signals_fit({"x", {0}, Sender::kController, 0, "", 9, false, 1, outside, 0, ""}));
}

TEST(FrameTable, EverySignalHasNameUnitAndComment) {
  for (const FrameDescription* frame : kFrames) {
    std::set<std::string> names;
    EXPECT_FALSE(std::string(frame->comment).empty()) << frame->name;
    for (int i = 0; i < frame->signal_count; ++i) {
      const Signal& signal = frame->signals[i];
      EXPECT_TRUE(names.insert(signal.name).second) << frame->name << "." << signal.name;
      EXPECT_FALSE(std::string(signal.unit).empty()) << frame->name << "." << signal.name;
      EXPECT_FALSE(std::string(signal.comment).empty()) << frame->name << "." << signal.name;
      for (int k = 0; k < signal.names.count; ++k)
        EXPECT_LE(signal.names.entries[k].value, signal.names.flags ? signal.length - 1 : highest_raw(signal))
            << frame->name << "." << signal.name << " " << signal.names.entries[k].name;
    }
  }
}

std::string name_of(const ValueTable& table, int value) {
  for (int i = 0; i < table.count; ++i)
    if (table.entries[i].value == value) return table.entries[i].name;
  return "";
}

TEST(FrameTable, NamesAgreeWithTheEnums) {
  const ValueTable estimates = states(kEstimateStates);
  EXPECT_EQ(name_of(estimates, static_cast<int>(EstimateStatus::kValid)), "VALID");
  EXPECT_EQ(name_of(estimates, static_cast<int>(EstimateStatus::kStale)), "STALE");
  EXPECT_EQ(name_of(estimates, static_cast<int>(EstimateStatus::kBiasSuspect)), "BIAS_SUSPECT");
  EXPECT_EQ(name_of(estimates, static_cast<int>(EstimateStatus::kSkewed)), "SKEWED");
  EXPECT_EQ(name_of(estimates, static_cast<int>(EstimateStatus::kIllConditioned)), "ILL_CONDITIONED");
  EXPECT_EQ(name_of(estimates, static_cast<int>(EstimateStatus::kNoExcitation)), "NO_EXCITATION");
  EXPECT_EQ(name_of(estimates, static_cast<int>(EstimateStatus::kSaturated)), "SATURATED");
  EXPECT_EQ(name_of(estimates, static_cast<int>(EstimateStatus::kModelSuspect)), "MODEL_SUSPECT");
  EXPECT_EQ(name_of(states(kQualityStates), static_cast<int>(EstimateStatus::kUntested)), "UNTESTED");
  EXPECT_EQ(name_of(states(kModes), static_cast<int>(ControllerMode::kEmergencyStop)), "EMERGENCY_STOP");
  EXPECT_EQ(name_of(states(kModes), static_cast<int>(ControllerMode::kFault)), "FAULT");
  EXPECT_EQ(name_of(flags(kFaults), static_cast<int>(Fault::kCanBusOff)), "CAN_BUS_OFF");
  EXPECT_EQ(name_of(flags(kFaults), static_cast<int>(Fault::kDriveNotTaken)), "DRIVE_NOT_TAKEN");
  EXPECT_EQ(name_of(states(kEmergencyCodes), static_cast<int>(EmergencyCode::kSamplesMissed)), "SAMPLES_MISSED");
  EXPECT_EQ(name_of(states(kQuantities), static_cast<int>(Quantity::kAcceleration)), "acceleration");
  EXPECT_EQ(name_of(states(kQuantities), kNoQuantity), "NONE");
  EXPECT_EQ(place_of_node(kBaseNode), kPlaceBase);
  EXPECT_EQ(place_of_node(kGroundNode), kPlaceGround);
  EXPECT_EQ(place_of_node(0), 1);
}

}  // namespace
}  // namespace can
}  // namespace firmware

// What travels on the bus, one plain struct per frame. Units and meaning of each field: frame_table.hpp. Fields wider
// than their signal are clamped to its range; counters that the table calls "modulo" wrap instead.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/values/place.hpp"
#include "firmware/estimator_core.hpp"
#include "firmware/identification/estimate.hpp"
#include "firmware/supervision/controller_mode.hpp"

namespace firmware {

enum class HeartbeatState : uint8_t { kBootUp = 0, kStopped = 4, kOperational = 5, kPreOperational = 127 };

// CANopen's network commands, as far as they mean something here.
enum class NetworkCommandCode : uint8_t { kStart = 1, kStop = 2, kReset = 129 };
struct NetworkCommand {
  NetworkCommandCode command = NetworkCommandCode::kStop;
  uint8_t node = 0;  // 0: all
};

// Bit numbers of NodeStatus::faults.
enum class Fault : uint8_t {
  kEmergencyStop = 0,
  kSensorSaturated = 1,
  kSensorLost = 2,
  kSamplesMissed = 3,
  kDriveLimit = 4,
  kWatchdog = 5,
  kCanErrorPassive = 6,
  kCanBusOff = 7,
  kCanOverflow = 8,
  kConfiguration = 9,
  kStore = 10,
  kAccumulatorSaturated = 11,
  kDriveNotTaken = 12,
};
constexpr uint16_t fault_bit(Fault fault) { return static_cast<uint16_t>(1u << static_cast<int>(fault)); }

enum class EmergencyCode : uint16_t {
  kNoError = 0x0000,
  kGeneric = 0x1000,
  kHardware = 0x5000,
  kSoftware = 0x6000,
  kWatchdog = 0x6100,
  kConfiguration = 0x6300,
  kStore = 0x6310,
  kCanOverflow = 0x8110,
  kCanErrorPassive = 0x8120,
  kCanBusOffRecovered = 0x8140,
  kSyncLost = 0x8700,
  kEmergencyStop = 0xFF01,
  kSensorSaturated = 0xFF02,
  kSensorLost = 0xFF03,
  kSamplesMissed = 0xFF04,
  kDriveLimit = 0xFF05,
  kDriveNotTaken = 0xFF06,
  kNotSettled = 0xFF07,
};

struct Emergency {
  EmergencyCode code = EmergencyCode::kNoError;
  uint8_t error_register = 0;
  uint8_t place = kNoPlace;
  uint8_t quantity = kNoQuantity;
  uint32_t detail = 0;
};

struct NodeStatus {
  uint16_t faults = 0;
  ControllerMode mode = ControllerMode::kInitialising;
  EstimateStatus quality = EstimateStatus::kStale;
  uint8_t condition_log2 = 0;
  uint32_t update_counter = 0;
};
// Faults and mode are the caller's; the rest comes from the estimates (null: none yet).
NodeStatus node_status(const Estimates* estimates, ControllerMode mode, uint16_t faults);

struct NodeHealth {
  uint32_t uptime_s = 0;
  CoreHealth core;
  uint32_t bus_off = 0;
};

struct BusHealth {
  uint32_t restarts = 0;
  uint32_t error_passive = 0;
  uint32_t controller_overflow = 0;
  uint32_t interface_down = 0;
  uint32_t frames_not_sent = 0;
  uint32_t sensor_frames_lost = 0;
};

struct Identity {
  uint8_t version_major = 0, version_minor = 0, version_patch = 0;
  uint8_t parameters = 0;
  uint32_t configuration_crc = 0;
};

struct WindowResult {
  uint32_t residual_e9 = 0;  // 1e-9 per count
  uint32_t equations = 0;
  uint32_t window = 0;
};
WindowResult window_result(const Estimates& estimates);

enum class DriveState : uint8_t { kOff = 0, kEnabled = 1, kStopped = 2 };
struct DriveCommand {
  int32_t drive_q31 = 0;  // the most negative int32 is -1
  uint32_t sequence = 0;
  DriveState state = DriveState::kOff;
};

}  // namespace firmware

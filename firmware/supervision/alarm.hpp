// Why the rig was stopped, or what deserves attention while it runs. rig_controller/safety/alarm_message.hpp turns these into
// the codes and bits that travel on the bus.
#pragma once
#include <cstdint>

namespace firmware {

enum class AlarmCause : uint8_t {
  kNone = 0,
  // These stop the drive and stay until a reset command.
  kEmergencyStop,    // the emergency-stop line
  kSensorSaturated,  // a channel at full scale several samples in a row; detail: samples
  kSensorLost,       // samples missing or overdue while driving; detail: samples, or ms
  kSensorFault,      // the sample source failed or ended while driving
  kDriveLimit,       // a command beyond the drive limits was caught; detail: the command, Q0.31
  kResponseLimit,    // a channel beyond its configured limit; detail: the code
  kStepLate,         // the controller itself was not run in time; detail: ms
  kDriveNotTaken,    // the drive output refused a command, or the bus took none; detail: for how long, ms
  kRelayNotTaken,    // the relay output refused a command
  kWorkerLate,       // the worker of the estimates does not come back; detail: ms
  kConfiguration,    // programme out of range; detail: ProgrammeFault * 256 + level
  // These are told and counted, the rig goes on.
  kSamplesMissed,    // a gap too short to stop for; detail: samples
  kNotSettled,       // the response did not settle within its limit; detail: level
  kStore,            // the configuration could not be saved, or what was stored is damaged
  kCanOverflow,      // transmit frames were given up, or the controller lost received ones; detail: how many so far
  kCanErrorPassive,  // the CAN controller became error-passive; detail: how often so far
  kCanRecovered,     // back from bus-off or from an interface that was down; detail: how often so far
};

constexpr bool stops_drive(AlarmCause cause) {
  return cause != AlarmCause::kNone && cause <= AlarmCause::kConfiguration;
}

constexpr uint8_t kNoNode = 0xFF;

struct Alarm {
  AlarmCause cause = AlarmCause::kNone;
  uint32_t detail = 0;
  uint8_t node = kNoNode;  // of the channel concerned, with its quantity
  uint8_t quantity = 0;

  explicit operator bool() const { return cause != AlarmCause::kNone; }
};

}  // namespace firmware

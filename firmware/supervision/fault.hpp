// Why the rig was stopped, or what is wrong while it runs: one number per cause, sent as the code of the emergency frame.
// The ranges follow CANopen: 0x50 hardware, 0x61 software, 0x63 data, 0x73 sensors, 0x81 communication, 0x90 external,
// 0xFF this device.
#pragma once
#include <cstdint>

namespace firmware {

enum class FaultCode : uint16_t {
  kNone = 0x0000,
  // These stop the drive and stay until a reset command.
  kOutputFailed = 0x5001,        // drive or relay did not take a command; detail: 1 drive, 2 relay
  kStepLate = 0x6101,            // the controller itself was not run in time; detail: ms late
  kConfiguration = 0x6320,       // programme or limits out of range; channel: level, detail: ProgrammeFault
  kSensorSaturated = 0x7301,     // a channel at full scale several samples in a row; detail: samples
  kSensorFramesLost = 0x7302,    // samples missing or overdue while driving; detail: samples or ms
  kSensorFault = 0x7303,         // the sample source failed or ended while driving
  kEmergencyStop = 0x9001,       // the emergency-stop line
  kDriveLimit = 0xFF01,          // a command beyond the drive limits was caught; detail: command >> 16
  kResponseLimit = 0xFF02,       // a channel beyond its configured limit; detail: code >> 8
  // These are told and counted, the rig goes on.
  kMissedSamples = 0x7311,       // a gap too short to stop for; detail: samples
  kFramesDropped = 0x8110,       // transmit frames were given up; detail: how many
  kBusPassive = 0x8120,          // the CAN controller became error-passive
  kBusRecovered = 0x8140,        // back from bus-off or from an interface that was down; detail: bus-off count
  kLevelUnsettled = 0xFF11,      // the response did not settle within the limit; channel: level
};

constexpr bool stops_drive(FaultCode code) {
  switch (code) {
    case FaultCode::kNone:
    case FaultCode::kMissedSamples:
    case FaultCode::kFramesDropped:
    case FaultCode::kBusPassive:
    case FaultCode::kBusRecovered:
    case FaultCode::kLevelUnsettled:
      return false;
    default:
      return true;
  }
}

constexpr uint8_t kNoChannel = 0xFF;

struct Fault {
  FaultCode code = FaultCode::kNone;
  uint8_t channel = kNoChannel;  // node * kQuantities + quantity, or as said at the code
  uint16_t detail = 0;
};

}  // namespace firmware

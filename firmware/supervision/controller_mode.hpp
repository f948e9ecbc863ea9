// What the controller is doing. The numbers travel on the bus (frame `status`).
#pragma once
#include <cstdint>

namespace firmware {

enum class ControllerMode : uint8_t {
  kInitialising = 0,
  kIdle = 1,
  kRamp = 2,
  kSettle = 3,
  kIntegrate = 4,
  kFreeDecay = 5,
  kDone = 6,
  kEmergencyStop = 7,
  kFault = 8,
};

}  // namespace firmware

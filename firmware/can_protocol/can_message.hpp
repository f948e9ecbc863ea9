// A CAN frame as the protocol sees it: no bus, no time, no driver flags.
#pragma once
#include <cstdint>

namespace firmware {

struct CanMessage {
  uint32_t id = 0;  // 11 bits, or 29 where extended
  bool extended = false;
  bool fd = false;     // CAN FD: up to 64 bytes
  uint8_t length = 0;  // bytes in data
  uint8_t data[64] = {};
};

}  // namespace firmware

// A CAN frame, the same for the protocol, the bus and the logs.
#pragma once
#include <cstdint>

namespace firmware {

struct CanFrame {
  uint32_t id = 0;  // 11 or 29 bits
  bool extended = false;
  bool remote = false;
  bool error = false;  // an error frame: id holds the SocketCAN error class bits
  bool fd = false;
  uint8_t flags = 0;   // CAN FD: bit 0 bit-rate switch, bit 1 error state indicator
  uint8_t length = 0;  // bytes: 0 to 8, CAN FD up to 64
  uint8_t data[64] = {};
  uint64_t time_ns = 0;  // reception time, from the kernel or the simulator
};

}  // namespace firmware

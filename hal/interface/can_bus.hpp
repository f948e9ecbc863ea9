// A CAN bus as the controller sees it.
#pragma once
#include <cstdint>

namespace hal {

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

enum class CanResult : uint8_t {
  kDone,       // sent or received
  kEmpty,      // nothing to receive
  kQueueFull,  // transmit queue full: the frame was not taken, try it again later
  kBusDown,    // interface down or bus-off
  kFault,      // the driver gave an unexpected error
};

class CanBus {
 public:
  virtual CanResult send(const CanFrame& frame) = 0;  // never blocks
  virtual CanResult receive(CanFrame& frame) = 0;     // never blocks
  // Received frames that were dropped because receive() was called too late; since start.
  virtual uint32_t receive_overflows() const { return 0; }

 protected:
  ~CanBus() = default;
};

}  // namespace hal

// A CAN bus as the controller sees it.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/can_frame.hpp"

namespace hal {

using firmware::CanFrame;

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

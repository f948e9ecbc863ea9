// The controller's CAN frames in the kernel's form and back. Pure: no socket is needed.
#pragma once
#include <linux/can.h>

#include <cstddef>

#include "hal/interface/can_bus.hpp"

namespace hal {

// A frame of the kernel: classic (CAN_MTU bytes) or FD (CANFD_MTU bytes). Both layouts agree in their first fields.
struct KernelCanFrame {
  canfd_frame frame{};
  size_t size = 0;  // CAN_MTU or CANFD_MTU
};

// CAN FD lengths above 8 are rounded up to the next that exists (12, 16, 20, 24, 32, 48, 64); the filling is zero.
KernelCanFrame to_kernel(const CanFrame& frame);

// size: what the kernel delivered. False for anything else than a whole frame. time_ns is left alone.
bool from_kernel(const canfd_frame& kernel, size_t size, CanFrame& frame);

}  // namespace hal

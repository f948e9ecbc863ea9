#include "hal/linux/can/can_frame_format.hpp"

#include <algorithm>
#include <cstring>

namespace hal {
namespace {

uint8_t fd_length(uint8_t length) {
  constexpr uint8_t kLengths[] = {12, 16, 20, 24, 32, 48, 64};
  if (length <= 8) return length;
  for (const uint8_t allowed : kLengths)
    if (length <= allowed) return allowed;
  return 64;
}

}  // namespace

KernelCanFrame to_kernel(const CanFrame& frame) {
  KernelCanFrame result;
  result.size = frame.fd ? CANFD_MTU : CAN_MTU;
  canfd_frame& kernel = result.frame;
  kernel.can_id = frame.id & (frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  if (frame.error) kernel.can_id = (frame.id & CAN_ERR_MASK) | CAN_ERR_FLAG;
  if (frame.extended) kernel.can_id |= CAN_EFF_FLAG;
  if (frame.remote && !frame.fd) kernel.can_id |= CAN_RTR_FLAG;
  kernel.len = frame.fd ? fd_length(frame.length) : std::min<uint8_t>(frame.length, CAN_MAX_DLEN);
  if (frame.fd) kernel.flags = frame.flags & (CANFD_BRS | CANFD_ESI);
  if (!frame.remote) std::memcpy(kernel.data, frame.data, std::min<size_t>(frame.length, kernel.len));
  return result;
}

bool from_kernel(const canfd_frame& kernel, size_t size, CanFrame& frame) {
  if (size != CAN_MTU && size != CANFD_MTU) return false;
  frame.fd = size == CANFD_MTU;
  if (kernel.len > (frame.fd ? CANFD_MAX_DLEN : CAN_MAX_DLEN)) return false;
  frame.error = (kernel.can_id & CAN_ERR_FLAG) != 0;
  frame.extended = !frame.error && (kernel.can_id & CAN_EFF_FLAG) != 0;
  frame.remote = !frame.error && (kernel.can_id & CAN_RTR_FLAG) != 0;
  frame.id = kernel.can_id & (frame.error ? CAN_ERR_MASK : frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.flags = frame.fd ? static_cast<uint8_t>(kernel.flags & (CANFD_BRS | CANFD_ESI)) : uint8_t{0};
  frame.length = kernel.len;
  std::memset(frame.data, 0, sizeof frame.data);
  if (!frame.remote) std::memcpy(frame.data, kernel.data, kernel.len);
  return true;
}

}  // namespace hal

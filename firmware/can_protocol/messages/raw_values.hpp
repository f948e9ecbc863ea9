// Of the unpack_ functions: the raw values of a frame, and fields from them.
#pragma once
#include "firmware/can_protocol/messages/packing.hpp"

namespace firmware {

// The raw values of a frame in the order of the table; false where the message is another.
template <size_t N>
bool unpack(const can::FrameDescription& frame, const CanFrame& message, int& node, int64_t (&raw)[N]) {
  int member = 0;
  if (!can::is_frame(frame, message, node, member)) return false;
  for (size_t i = 0; i < N; ++i) raw[i] = can::get_raw(message, frame.signals[i]);
  return true;
}

template <typename T>
void assign(T& field, int64_t raw) {
  field = static_cast<T>(raw);
}

}  // namespace firmware

#include "firmware/can_protocol/messages/packing.hpp"

#include "firmware/can_protocol/frame_plan_check.hpp"
#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace can {

static_assert(ids_do_not_collide(kFrames), "two frames share an identifier");
static_assert(all_signals_fit(kFrames), "a signal leaves its frame or overlaps another");

void set_raw(CanFrame& message, const Signal& signal, int64_t raw, int bit_offset) {
  if (raw < lowest_raw(signal)) raw = lowest_raw(signal);
  if (raw > highest_raw(signal)) raw = highest_raw(signal);
  FIRMWARE_PRECONDITION(bit_offset + signal.start_bit + signal.length <= 8 * static_cast<int>(sizeof message.data));
  auto bits = static_cast<uint32_t>(static_cast<uint64_t>(raw));  // a signal has at most 32
  unsigned left = signal.length, position = static_cast<unsigned>(bit_offset + signal.start_bit);
  while (left > 0) {  // what falls into one byte at a time
    const unsigned at = position % 8, count = left < 8 - at ? left : 8 - at;
    const uint32_t mask = ((1u << count) - 1) << at;
    uint8_t& byte = message.data[position / 8];
    byte = static_cast<uint8_t>((byte & ~mask) | ((bits << at) & mask));
    bits >>= count;
    left -= count;
    position += count;
  }
}

int64_t get_raw(const CanFrame& message, const Signal& signal, int bit_offset) {
  FIRMWARE_PRECONDITION(bit_offset + signal.start_bit + signal.length <= 8 * static_cast<int>(sizeof message.data));
  int64_t raw = 0;
  for (int i = 0; i < signal.length; ++i) {
    const int position = bit_offset + signal.start_bit + i;
    raw |= static_cast<int64_t>((message.data[position / 8] >> (position % 8)) & 1) << i;
  }
  return raw > highest_raw(signal) ? raw - (int64_t{1} << signal.length) : raw;
}

CanFrame empty_frame(const FrameDescription& frame, int node, int member) {
  CanFrame message;
  message.id = frame_id(frame.ids, node, member);
  message.fd = frame.fd;
  message.flags = frame.fd ? 1 : 0;  // the data part at the higher bit rate
  message.length = frame.length;
  return message;
}

bool is_frame(const FrameDescription& frame, const CanFrame& message, int& node, int& member) {
  if (message.extended || message.remote || message.error || message.fd != frame.fd || message.length < frame.length)
    return false;
  const IdPlan& ids = frame.ids;
  const bool per_node = ids.node_stride > 0;
  for (int n = per_node ? kFirstNode : 0; n <= (per_node ? kLastNode : 0); ++n) {
    const int64_t offset = static_cast<int64_t>(message.id) - frame_id(ids, n);
    for (int bank = 0; bank < bank_count(ids); ++bank) {
      const int64_t place = offset - ids.bank_offset[bank];
      if (place < 0 || place >= ids.bank_members) continue;
      const int64_t candidate = bank * ids.bank_members + place;
      if (candidate >= ids.members) continue;
      node = n;
      member = static_cast<int>(candidate);
      return true;
    }
  }
  return false;
}

Address identify(const CanFrame& message) {
  Address address;
  for (const FrameDescription* frame : kFrames) {
    if (is_frame(*frame, message, address.node, address.member)) {
      address.frame = frame;
      break;
    }
  }
  return address;
}

}  // namespace can
}  // namespace firmware

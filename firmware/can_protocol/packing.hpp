// Structs to frames and back, driven by frame_table.hpp. Integers only; a field that does not fit its signal is
// clamped, and an unpack_ function is false where the frame is none of its kind (identifier, length or CAN FD flag
// differ).
#pragma once
#include "firmware/can_protocol/can_message.hpp"
#include "firmware/can_protocol/frame_table.hpp"
#include "firmware/can_protocol/messages.hpp"

namespace firmware {
namespace can {

// One signal in a frame; bit_offset is that of its record. Reading past message.length gives the bits that data holds
// there.
void set_raw(CanMessage& message, const Signal& signal, int64_t raw, int bit_offset = 0);  // clamps
int64_t get_raw(const CanMessage& message, const Signal& signal, int bit_offset = 0);

// An empty frame of the table with its identifier and length set.
CanMessage empty_frame(const Frame& frame, int node, int member = 0);

// raw: one value per signal, in the order of the table.
template <const Frame& frame, size_t N>
CanMessage pack(int node, int member, const int64_t (&raw)[N]) {
  static_assert(N == frame.signal_count, "one raw value per signal of the frame");
  CanMessage message = empty_frame(frame, node, member);
  for (size_t i = 0; i < N; ++i) set_raw(message, frame.signals[i], raw[i]);
  return message;
}

// What a received identifier stands for; frame is null where the protocol does not know it.
struct Address {
  const Frame* frame = nullptr;
  int node = 0;  // 0 where the frame is the rig's
  int member = 0;
};
Address identify(const CanMessage& message);

// As identify(), for one kind of frame: cheap enough for every received sensor frame. Longer frames than described are
// taken.
bool is_frame(const Frame& frame, const CanMessage& message, int& node, int& member);

}  // namespace can

CanMessage pack_sync();
CanMessage pack_network_command(const NetworkCommand& command);
CanMessage pack_heartbeat(int node, HeartbeatState state);
CanMessage pack_emergency(int node, const Emergency& emergency);
CanMessage pack_status(int node, const NodeStatus& status);
CanMessage pack_health(int node, const NodeHealth& health);
CanMessage pack_bus_health(int node, const BusHealth& health);
CanMessage pack_identity(int node, const Identity& identity);
CanMessage pack_window(int node, const WindowResult& window);
CanMessage pack_diagnosis(int node, const Diagnosis& diagnosis);
CanMessage pack_parameter(int node, const ParameterDescription& parameter);
CanMessage pack_scaling(int node, const ChannelScaling& scaling);
CanMessage pack_range(int node, const ChannelRange& range);
CanMessage pack_drive(int node, const DriveCommand& drive);

bool is_sync(const CanMessage& message);
bool unpack_network_command(const CanMessage& message, NetworkCommand& command);
bool unpack_heartbeat(const CanMessage& message, int& node, HeartbeatState& state);
bool unpack_emergency(const CanMessage& message, int& node, Emergency& emergency);
bool unpack_status(const CanMessage& message, int& node, NodeStatus& status);
bool unpack_health(const CanMessage& message, int& node, NodeHealth& health);
bool unpack_bus_health(const CanMessage& message, int& node, BusHealth& health);
bool unpack_identity(const CanMessage& message, int& node, Identity& identity);
bool unpack_window(const CanMessage& message, int& node, WindowResult& window);
bool unpack_diagnosis(const CanMessage& message, int& node, Diagnosis& diagnosis);
bool unpack_parameter(const CanMessage& message, int& node, ParameterDescription& parameter);
bool unpack_scaling(const CanMessage& message, int& node, ChannelScaling& scaling);
bool unpack_range(const CanMessage& message, int& node, ChannelRange& range);
bool unpack_drive(const CanMessage& message, int& node, DriveCommand& drive);

}  // namespace firmware

// Structs to frames and back, driven by frame_table.hpp. Integers only; a field that does not fit its signal is
// clamped, and an unpack_ function is false where the frame is none of its kind (identifier, length or CAN FD flag
// differ).
#pragma once
#include "firmware/can_protocol/can_frame.hpp"
#include "firmware/can_protocol/frame_table.hpp"
#include "firmware/can_protocol/messages/description_messages.hpp"
#include "firmware/can_protocol/messages/diagnosis_message.hpp"
#include "firmware/can_protocol/messages/messages.hpp"

namespace firmware {
namespace can {

// One signal in a frame; bit_offset is that of its record. Reading past message.length gives the bits that data holds
// there.
void set_raw(CanFrame& message, const Signal& signal, int64_t raw, int bit_offset = 0);  // clamps
int64_t get_raw(const CanFrame& message, const Signal& signal, int bit_offset = 0);

// An empty frame of the table with its identifier and length set.
CanFrame empty_frame(const FrameDescription& frame, int node, int member = 0);

// raw: one value per signal, in the order of the table.
template <const FrameDescription& frame, size_t N>
CanFrame pack(int node, int member, const int64_t (&raw)[N]) {
  static_assert(N == frame.signal_count, "one raw value per signal of the frame");
  CanFrame message = empty_frame(frame, node, member);
  for (size_t i = 0; i < N; ++i) set_raw(message, frame.signals[i], raw[i]);
  return message;
}

// What a received identifier stands for; frame is null where the protocol does not know it.
struct Address {
  const FrameDescription* frame = nullptr;
  int node = 0;  // 0 where the frame is the rig's
  int member = 0;
};
Address identify(const CanFrame& message);

// As identify(), for one kind of frame: cheap enough for every received sensor frame. Longer frames than described are
// taken.
bool is_frame(const FrameDescription& frame, const CanFrame& message, int& node, int& member);

}  // namespace can

CanFrame pack_sync();
CanFrame pack_network_command(const NetworkCommand& command);
CanFrame pack_heartbeat(int node, HeartbeatState state);
CanFrame pack_emergency(int node, const Emergency& emergency);
CanFrame pack_status(int node, const NodeStatus& status);
CanFrame pack_health(int node, const NodeHealth& health);
CanFrame pack_bus_health(int node, const BusHealth& health);
CanFrame pack_identity(int node, const Identity& identity);
CanFrame pack_window(int node, const WindowResult& window);
CanFrame pack_diagnosis(int node, const Diagnosis& diagnosis);
CanFrame pack_parameter(int node, const ParameterDescription& parameter);
CanFrame pack_scaling(int node, const ChannelScaling& scaling);
CanFrame pack_range(int node, const ChannelRange& range);
CanFrame pack_drive(int node, const DriveCommand& drive);

bool is_sync(const CanFrame& message);
bool unpack_network_command(const CanFrame& message, NetworkCommand& command);
bool unpack_heartbeat(const CanFrame& message, int& node, HeartbeatState& state);
bool unpack_emergency(const CanFrame& message, int& node, Emergency& emergency);
bool unpack_status(const CanFrame& message, int& node, NodeStatus& status);
bool unpack_health(const CanFrame& message, int& node, NodeHealth& health);
bool unpack_bus_health(const CanFrame& message, int& node, BusHealth& health);
bool unpack_identity(const CanFrame& message, int& node, Identity& identity);
bool unpack_window(const CanFrame& message, int& node, WindowResult& window);
bool unpack_diagnosis(const CanFrame& message, int& node, Diagnosis& diagnosis);
CanFrame pack_diagnosis_size(int node, const Diagnosis& diagnosis);
bool unpack_diagnosis_size(const CanFrame& message, int& node, Diagnosis& diagnosis);  // fills size and corrected
CanFrame pack_diagnosis_rival(int node, const Diagnosis& diagnosis);
bool unpack_diagnosis_rival(const CanFrame& message, int& node, Diagnosis& diagnosis);  // fills the rival alone
bool unpack_parameter(const CanFrame& message, int& node, ParameterDescription& parameter);
bool unpack_scaling(const CanFrame& message, int& node, ChannelScaling& scaling);
bool unpack_range(const CanFrame& message, int& node, ChannelRange& range);
bool unpack_drive(const CanFrame& message, int& node, DriveCommand& drive);

}  // namespace firmware

#include "firmware/rig_controller/bus/description_frames.hpp"

#include "firmware/can_protocol/messages/packing.hpp"

namespace firmware {

void DescriptionFrames::send_some() {
  while (next_parameter_ < configuration_.core.unknown_count && queue_.has_room_for_more())
    send_parameter(next_parameter_++);
  while (next_channel_ < kMaxNodes * kQuantities && queue_.has_room_for_more()) {
    const int channel = next_channel_++;
    send_channel(channel / kQuantities, static_cast<Quantity>(channel % kQuantities));
  }
  waits_ = next_parameter_ < configuration_.core.unknown_count || next_channel_ < kMaxNodes * kQuantities;
}

void DescriptionFrames::send_parameter(int unknown) {
  ParameterDescription description;
  if (!describe_parameter(configuration_.core, unknown, false, description)) return;
  const int node = description.place_a > 0 ? description.place_a - 1 : 0;
  describe_parameter(configuration_.core, unknown, rotating(node), description);
  queue_.push(pack_parameter(configuration_.node.node, description), false);
}

void DescriptionFrames::send_channel(int node, Quantity quantity) {
  const ChannelConfiguration& channel = configuration_.core.channels[node][static_cast<int>(quantity)];
  if (!channel.present) return;
  const uint8_t own = configuration_.node.node;
  queue_.push(pack_scaling(own, channel_scaling(channel, node, quantity, rotating(node))), false);
  queue_.push(pack_range(own, channel_range(channel, node, quantity, rotating(node))), false);
}

}  // namespace firmware

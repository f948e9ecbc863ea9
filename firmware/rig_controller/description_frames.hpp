// The frames that name the estimates and the channels: a few at a time, behind everything else.
#pragma once
#include "firmware/rig_controller/controller_configuration.hpp"
#include "firmware/rig_controller/transmit_queue.hpp"

namespace firmware {

class DescriptionFrames {
 public:
  // Both must outlive this.
  DescriptionFrames(const ControllerConfiguration& configuration, TransmitQueue& queue)
      : configuration_(configuration), queue_(queue) {}

  void tell_parameters() { next_parameter_ = 0; }  // all of them, from now on
  void tell_channels() { next_channel_ = 0; }
  void send_some();
  bool wait() const {  // for room in the queue
    return next_parameter_ < configuration_.core.unknown_count || next_channel_ < kMaxNodes * kQuantities;
  }

 private:
  bool rotating(int node) const { return node < 32 && (configuration_.node.rotating_nodes >> node & 1) != 0; }
  void send_parameter(int unknown);
  void send_channel(int node, Quantity quantity);

  const ControllerConfiguration& configuration_;
  TransmitQueue& queue_;
  int next_parameter_ = 0;  // the next to be told; kMaxUnknowns: none
  int next_channel_ = 0;    // node * kQuantities + quantity; kMaxNodes * kQuantities: none
};

}  // namespace firmware

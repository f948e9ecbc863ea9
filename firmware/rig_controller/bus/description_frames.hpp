// The frames that name the estimates and the channels: a few at a time, behind everything else.
#pragma once
#include "firmware/rig_controller/bus/transmit_queue.hpp"
#include "firmware/rig_controller/settings/controller_configuration.hpp"

namespace firmware {

class DescriptionFrames {
 public:
  // Both must outlive this.
  DescriptionFrames(const ControllerConfiguration& configuration, TransmitQueue& queue)
      : configuration_(configuration), queue_(queue) {}

  void tell_parameters() {  // all of them, from now on
    next_parameter_ = 0;
    waits_ = true;
  }
  void tell_channels() {
    next_channel_ = 0;
    waits_ = true;
  }
  void send_some();
  bool wait() const { return waits_; }  // for room in the queue

 private:
  bool rotating(int node) const { return node < 32 && (configuration_.node.rotating_nodes >> node & 1) != 0; }
  void send_parameter(int unknown);
  void send_channel(int node, Quantity quantity);

  const ControllerConfiguration& configuration_;
  TransmitQueue& queue_;
  bool waits_ = true;
  int next_parameter_ = 0;  // the next to be told; kMaxUnknowns: none
  int next_channel_ = 0;    // node * kQuantities + quantity; kMaxNodes * kQuantities: none
};

}  // namespace firmware

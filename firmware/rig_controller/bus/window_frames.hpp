// The estimates of the last window on their way to the bus, and what the core says of its own model.
#pragma once
#include "firmware/can_protocol/messages/diagnosis_message.hpp"
#include "firmware/rig_controller/bus/transmit_queue.hpp"
#include "firmware/rig_controller/settings/controller_configuration.hpp"

namespace firmware {

class WindowFrames {
 public:
  // Both must outlive this, and so must every window's estimates until the next one or forget().
  WindowFrames(const ControllerConfiguration& configuration, TransmitQueue& queue)
      : configuration_(configuration), queue_(queue) {}

  void send(const Estimates& estimates, bool judged);  // judged: its warrant is to be told too
  void send_some_floats();  // the estimates once more, a few at a time: they say nothing new, so all else goes first
  bool floats_wait() const { return next_float_ < floats_; }
  void repeat_diagnosis();  // the last one, where there is one
  void forget();            // also what still waits for the bus

  const Estimates* estimates() const { return estimates_; }  // of the last window; nullptr before the first
  const Diagnosis& diagnosis() const { return diagnosis_; }  // of the last judgement

 private:
  void judge(const Estimates& estimates);
  void send_diagnosis();

  const ControllerConfiguration& configuration_;
  TransmitQueue& queue_;
  const Estimates* estimates_ = nullptr;
  int next_float_ = 0, floats_ = 0;  // frames of float estimates: the next one, and how many there are
  Diagnosis diagnosis_;
  bool judged_ = false;  // diagnosis_ holds a judgement of the last window
};

}  // namespace firmware

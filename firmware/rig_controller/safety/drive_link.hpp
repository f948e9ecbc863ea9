// The drive command on its way to the shaker amplifier: to a converter of this board and, with drive_on_can, as a frame
// on the bus. A command is delivered when each of its ways has taken it; what waits in the transmit queue is not.
//
// From one delivered command to the next the drive changes by the slew limit at the most, also when some in between
// were not delivered. Zero is exempt: a stop and the release of a free decay go there at once.
#pragma once
#include <cstdint>

#include "firmware/can_protocol/messages/messages.hpp"
#include "firmware/excitation/drive.hpp"
#include "firmware/rig_controller/bus/transmit_queue.hpp"
#include "hal/interface/drive_output.hpp"

namespace firmware {

class DriveLink {
 public:
  DriveLink(hal::DriveOutput& output, TransmitQueue& queue) : output_(output), queue_(queue) {}
  void configure(uint8_t node, bool on_can, Drive step_per_sample);

  // The command for this sample, as far as the slew limit lets it go from what was delivered last.
  Drive reachable(Drive wanted) const;
  // False: the converter refused it.
  bool command(Drive drive, uint32_t sequence, uint64_t now_ns);
  // Zero and "hold the shaker still". False: the converter refused it. To be called again until delivered().
  bool stop(uint64_t now_ns);
  // To be called after the transmit queue was flushed.
  void note_sent();

  bool delivered() const { return taken_ && !frame_waits_; }
  bool zero_commanded() const { return commanded_ == Drive{}; }
  bool at_rest() const { return delivered() && zero_commanded(); }
  bool frame_waits() const { return frame_waits_; }
  // How long the bus has taken none of the commands; 0 where nothing waits.
  uint64_t waiting_ns(uint64_t now_ns) const { return frame_waits_ ? now_ns - waits_since_ns_ : 0; }

 private:
  void send(uint32_t sequence, DriveState state, uint64_t now_ns);

  hal::DriveOutput& output_;
  TransmitQueue& queue_;
  uint32_t frame_id_ = 0;
  uint8_t node_ = 0;
  bool on_can_ = false;
  Drive step_per_sample_;
  Drive commanded_;          // the newest command
  Drive delivered_command_;  // the newest one that was delivered
  bool taken_ = false;       // the converter has taken the newest command
  bool frame_waits_ = false;
  uint64_t waits_since_ns_ = 0;
};

}  // namespace firmware

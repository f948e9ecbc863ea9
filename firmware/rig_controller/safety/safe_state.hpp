// What may move the rig, and what stops it: the emergency-stop line, the relay, the drive command and the latched reason
// to stand still. All that reads that line or writes those outputs is here; docs/controller.md has the table of states.
//
//   kUnknown   before the first step: the outputs have not been commanded yet
//   kSafe      relay open and drive zero, both delivered; START may close the relay
//   kLive      relay closed, the drive follows the programme
//   kStopping  relay open and drive zero are commanded again in every step until both are delivered
//   kStopped   both delivered; a reason is latched until RESET
#pragma once
#include <cstdint>

#include "firmware/rig_controller/safety/drive_link.hpp"
#include "firmware/rig_controller/safety/emergency_line.hpp"
#include "firmware/supervision/alarm.hpp"
#include "hal/interface/digital_line.hpp"

namespace firmware {

class SafeState {
 public:
  enum class State : uint8_t { kUnknown, kSafe, kLive, kStopping, kStopped };
  // A drive command that the bus does not take for this long: after as much the amplifier has to go to zero by itself
  // (frame `drive`).
  static constexpr uint64_t kDriveTimeout_ns = 10000000;

  SafeState(hal::DigitalInput& emergency_stop, hal::DigitalOutput& relay, DriveLink& drive)
      : line_(emergency_stop), relay_(relay), drive_(drive) {}

  // First thing in a step.
  void begin_step(uint64_t now_ns) {
    now_ns_ = now_ns;
    pressed_ = false;
  }

  // Each returns an alarm that stopped the rig just now; kNone where nothing did.
  Alarm look_at_line() { return line_.pressed() ? line_pressed() : Alarm{}; }
  Alarm energise();                               // kSafe -> kLive
  Alarm command(Drive drive, uint32_t sequence);  // in kLive
  Alarm check_delivery();                         // after the transmit queue was flushed
  bool awaits_delivery() const { return state_ == State::kStopping || drive_.frame_waits(); }  // else it finds nothing
  Alarm end();               // kLive -> kSafe: the programme is done, the drive is down to zero
  Alarm stop(Alarm reason);  // from any state: latched, outputs to zero and open at once

  void make_safe();  // at start, and in every step of kStopping
  bool reset();  // kStopped -> kSafe. False: the line is or was pressed in this step, or the outputs are not safe yet

  State state() const { return state_; }
  bool live() const { return state_ == State::kLive; }
  bool may_start() const { return state_ == State::kSafe && !pressed_; }
  bool pressed() const { return pressed_; }  // the line, in this step
  bool tripped() const { return static_cast<bool>(latched_); }
  const Alarm& latched() const { return latched_; }
  uint32_t trips() const { return trips_; }
  // An output of this board has refused to become safe: then the watchdog is not to be fed. A frame that the bus does
  // not take is no such case, a restart of the board would not help it.
  bool output_refuses() const { return state_ == State::kStopping && refused_; }

 private:
  Alarm line_pressed();
  void settle();  // where relay and drive are to be safe: whether they are

  EmergencyLine line_;
  hal::DigitalOutput& relay_;
  DriveLink& drive_;
  State state_ = State::kUnknown;
  Alarm latched_;
  bool pressed_ = false;
  bool refused_ = false;  // relay or converter, at the last try
  bool relay_open_ = false;
  uint64_t now_ns_ = 0;
  uint32_t trips_ = 0;
};

}  // namespace firmware

// See bus_monitor.hpp.
#include "firmware/rig_controller/bus/bus_monitor.hpp"

namespace firmware {
namespace {

// linux/can/error.h
constexpr uint32_t kClassController = 0x004;
constexpr uint32_t kClassBusOff = 0x040;
constexpr uint32_t kClassRestarted = 0x100;
constexpr uint8_t kOverflowBits = 0x03;  // data[1]: receive, transmit
constexpr uint8_t kPassiveBits = 0x30;   // data[1]: receive, transmit
constexpr uint8_t kActiveBit = 0x40;     // data[1]

}  // namespace

BusEvent BusMonitor::recover() {
  if (state_ == BusState::kGood) return BusEvent::kNone;
  const bool was_away = !may_send();
  state_ = BusState::kGood;
  if (!was_away) return BusEvent::kNone;
  ++recoveries_;
  return BusEvent::kRecovered;
}

BusEvent BusMonitor::error_frame(const hal::CanFrame& frame, uint64_t now_ns) {
  if (frame.id & kClassBusOff) {
    if (state_ == BusState::kBusOff) return BusEvent::kNone;
    state_ = BusState::kBusOff;
    off_since_ns_ = now_ns;
    ++bus_off_;
    return BusEvent::kWentOff;
  }
  if (frame.id & kClassRestarted) {
    ++health_.restarts;
    return recover();
  }
  if (!(frame.id & kClassController)) return BusEvent::kNone;
  if (frame.data[1] & kOverflowBits) {
    ++health_.controller_overflow;
    return BusEvent::kOverflow;
  }
  if (frame.data[1] & kActiveBit) return recover();
  if (!(frame.data[1] & kPassiveBits) || state_ != BusState::kGood) return BusEvent::kNone;
  state_ = BusState::kPassive;
  ++health_.error_passive;
  return BusEvent::kBecamePassive;
}

BusEvent BusMonitor::frame_received() { return may_send() ? BusEvent::kNone : recover(); }

BusEvent BusMonitor::answer(hal::CanResult result, uint64_t now_ns) {
  if (result == hal::CanResult::kBusDown) {
    if (!may_send()) return BusEvent::kNone;
    state_ = BusState::kDown;
    ++health_.interface_down;
    return BusEvent::kWentDown;
  }
  const bool taken = result == hal::CanResult::kDone;
  if (state_ == BusState::kDown && (taken || result == hal::CanResult::kQueueFull)) return recover();
  if (!taken) return BusEvent::kNone;
  if (state_ == BusState::kBusOff && now_ns - off_since_ns_ >= kProbationNs) return recover();
  return BusEvent::kNone;
}

bool BusMonitor::trial_due(uint64_t now_ns) {
  if (may_send()) return true;
  if (state_ == BusState::kBusOff && now_ns - off_since_ns_ < kProbationNs) return false;
  if (now_ns < next_trial_ns_) return false;
  next_trial_ns_ = now_ns + kTrialNs;
  return true;
}

}  // namespace firmware

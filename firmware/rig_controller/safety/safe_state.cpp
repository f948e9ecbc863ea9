// See safe_state.hpp.
#include "firmware/rig_controller/safety/safe_state.hpp"

namespace firmware {

// Whoever looks at the line acts on what it sees: a look cannot swallow a press.
Alarm SafeState::line_pressed() {
  pressed_ = true;
  if (latched_.cause == AlarmCause::kEmergencyStop) return Alarm{};
  return stop({AlarmCause::kEmergencyStop});
}

Alarm SafeState::energise() {
  if (!may_start()) return Alarm{};
  if (!relay_.set(true)) return stop({AlarmCause::kRelayNotTaken});
  relay_open_ = false;
  state_ = State::kLive;
  return Alarm{};
}

Alarm SafeState::command(Drive drive, uint32_t sequence) {
  if (!live()) return Alarm{};
  return drive_.command(drive, sequence, now_ns_) ? Alarm{} : stop({AlarmCause::kDriveNotTaken});
}

Alarm SafeState::check_delivery() {
  drive_.note_sent();
  const uint64_t waiting_ns = drive_.waiting_ns(now_ns_);
  if (live() && waiting_ns >= kDriveTimeout_ns)
    return stop({AlarmCause::kDriveNotTaken, static_cast<uint32_t>(waiting_ns / 1000000)});
  if (state_ == State::kStopping) settle();
  return Alarm{};
}

Alarm SafeState::end() {
  if (!live()) return Alarm{};
  if (!relay_.set(false)) return stop({AlarmCause::kRelayNotTaken});
  relay_open_ = true;
  refused_ = false;
  drive_.zero_commanded() ? settle() : make_safe();
  return Alarm{};
}

// The first reason stays latched; an emergency stop takes its place.
Alarm SafeState::stop(Alarm reason) {
  ++trips_;
  if (!tripped() || reason.cause == AlarmCause::kEmergencyStop) latched_ = reason;
  make_safe();
  return reason;
}

void SafeState::make_safe() {
  relay_open_ =
      relay_.set(false);  // first: it cuts the power, and a converter on a hanging bus may not come back for a second
  const bool zero_taken = drive_.stop(now_ns_);
  refused_ = !zero_taken || !relay_open_;
  settle();
}

void SafeState::settle() {
  const bool delivered = relay_open_ && drive_.at_rest();
  state_ = !delivered ? State::kStopping : (tripped() ? State::kStopped : State::kSafe);
}

bool SafeState::reset() {
  const bool settled = state_ == State::kStopped || state_ == State::kSafe || (state_ == State::kLive && !tripped());
  if (pressed_ || !settled) return false;
  latched_ = Alarm{};
  if (state_ == State::kStopped) state_ = State::kSafe;
  return true;
}

}  // namespace firmware

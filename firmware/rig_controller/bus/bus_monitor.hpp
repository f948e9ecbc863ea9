// What is known of the CAN bus: from error frames, from the answers to sending and receiving, and from the passing of
// time.
//
//   good <-> passive         error-passive and active again
//   any -> bus_off -> good   on the restart message, on any received frame, or when a send works kProbationNs later
//   any -> down -> good      when a send or receive works again
#pragma once
#include <cstdint>

#include "firmware/can_protocol/messages/messages.hpp"
#include "hal/interface/can_bus.hpp"

namespace firmware {

enum class BusState : uint8_t { kGood, kPassive, kBusOff, kDown };
enum class BusEvent : uint8_t { kNone, kBecamePassive, kWentOff, kWentDown, kOverflow, kRecovered };

class BusMonitor {
 public:
  // Longer than the 100 ms restart time of the shipped network file.
  static constexpr uint64_t kProbationNs = 500000000;

  // An error frame in SocketCAN's form (linux/can/error.h): class bits in id, controller state in data[1].
  BusEvent error_frame(const hal::CanFrame& frame, uint64_t now_ns);
  BusEvent frame_received();
  BusEvent answer(hal::CanResult result, uint64_t now_ns);  // of send or receive

  BusState state() const { return state_; }
  bool may_send() const { return state_ != BusState::kBusOff && state_ != BusState::kDown; }
  // While the bus is off or down a trial is worth it only now and then.
  bool trial_due(uint64_t now_ns);

  // frames_not_sent and sensor_frames_lost are counted elsewhere.
  const BusHealth& health() const { return health_; }
  uint32_t bus_off_count() const { return bus_off_; }
  uint32_t recoveries() const { return recoveries_; }

 private:
  BusEvent recover();

  static constexpr uint64_t kTrialNs = 10000000;
  BusState state_ = BusState::kGood;
  uint64_t off_since_ns_ = 0;
  uint64_t next_trial_ns_ = 0;
  uint32_t bus_off_ = 0;
  uint32_t recoveries_ = 0;
  BusHealth health_;
};

}  // namespace firmware

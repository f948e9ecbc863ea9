// Alarms as they travel on the bus: the code of the emergency frame and the bit of the status frame.
#pragma once
#include "firmware/can_protocol/messages/messages.hpp"
#include "firmware/supervision/alarm.hpp"

namespace firmware {

EmergencyCode emergency_code(AlarmCause cause);
uint16_t status_bit(AlarmCause cause);         // 0 where the status frame has none
uint8_t error_register_bit(AlarmCause cause);  // object 1001, without the generic bit
Emergency emergency_of(const Alarm& alarm, uint8_t error_register);

// Emergency frames that wait for the inhibit time. One place per code: the same code again updates its detail. An
// urgent one (the drive has been stopped) goes in front and does not wait: it is latched, so it cannot flood the bus.
class AlarmQueue {
 public:
  void push(const Emergency& emergency, bool urgent);
  // The first one that may go out now.
  bool pop(uint64_t now_ns, uint64_t inhibit_ns, Emergency& emergency);
  int waiting() const { return count_; }

 private:
  static constexpr int kCapacity = 20;  // more than there are codes
  struct Place {
    Emergency emergency;
    bool urgent = false;
  };
  Place waiting_[kCapacity];
  int count_ = 0;
  bool sent_before_ = false;
  uint64_t last_ns_ = 0;
};

}  // namespace firmware

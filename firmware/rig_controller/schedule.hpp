// When something is due again, without drift: the next time is counted from the last due time, not from now.
#pragma once
#include <cstdint>
#include <initializer_list>

namespace firmware {

class Periodic {
 public:
  void start(uint64_t first_ns, uint64_t period_ns) {
    due_ns_ = first_ns;
    period_ns_ = period_ns;
  }
  // A new period counts from now; 0 stops.
  void change_period(uint64_t now_ns, uint64_t period_ns) { start(now_ns + period_ns, period_ns); }
  // True at most once per call; times that passed unseen are left out.
  bool due(uint64_t now_ns) {
    if (period_ns_ == 0 || now_ns < due_ns_) return false;
    due_ns_ += period_ns_;
    if (now_ns >= due_ns_) due_ns_ += ((now_ns - due_ns_) / period_ns_ + 1) * period_ns_;
    return true;
  }
  uint64_t next_ns() const { return period_ns_ == 0 ? UINT64_MAX : due_ns_; }

 private:
  uint64_t due_ns_ = 0;
  uint64_t period_ns_ = 0;
};

// What the node sends by the clock.
class NodeSchedule {
 public:
  Periodic heartbeat, status, second, five_seconds;

  // Whether any of them may be due; after having looked at all of them, settle().
  bool quiet(uint64_t now_ns) const { return now_ns < next_ns_; }
  void settle() {
    next_ns_ = heartbeat.next_ns();
    for (const Periodic* other : {&status, &second, &five_seconds})
      if (other->next_ns() < next_ns_) next_ns_ = other->next_ns();
  }
  void start(uint64_t now_ns) {
    next_ns_ = 0;
    second.start(now_ns, 1000000000);
    five_seconds.start(now_ns, 5000000000);
  }
  // heartbeat_ms 0: none.
  void apply(uint16_t heartbeat_ms, uint16_t status_ms, uint64_t now_ns) {
    next_ns_ = 0;
    heartbeat.start(now_ns + uint64_t{heartbeat_ms} * 1000000, uint64_t{heartbeat_ms} * 1000000);
    status.start(now_ns, uint64_t{status_ms} * 1000000);
  }
  void change_heartbeat(uint16_t heartbeat_ms, uint64_t now_ns) {
    next_ns_ = 0;
    heartbeat.change_period(now_ns, uint64_t{heartbeat_ms} * 1000000);
  }

 private:
  uint64_t next_ns_ = 0;
};

}  // namespace firmware

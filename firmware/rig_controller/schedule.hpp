// When something is due again, without drift: the next time is counted from the last due time, not from now.
#pragma once
#include <cstdint>

namespace firmware {

class Periodic {
 public:
  void start(uint64_t first_ns, uint64_t period_ns) {
    due_ns_ = first_ns;
    period_ns_ = period_ns;
  }
  // A new period counts from now; 0 stops.
  void change_period(uint64_t now_ns, uint64_t period_ns) { start(now_ns + period_ns, period_ns); }
  void run_now(uint64_t now_ns) { due_ns_ = now_ns; }
  // True at most once per call; times that passed unseen are left out.
  bool due(uint64_t now_ns) {
    if (period_ns_ == 0 || now_ns < due_ns_) return false;
    due_ns_ += ((now_ns - due_ns_) / period_ns_ + 1) * period_ns_;
    return true;
  }

 private:
  uint64_t due_ns_ = 0;
  uint64_t period_ns_ = 0;
};

// What the node sends by the clock.
struct NodeSchedule {
  Periodic heartbeat, status, second, five_seconds;

  void start(uint64_t now_ns) {
    second.start(now_ns, 1000000000);
    five_seconds.start(now_ns, 5000000000);
  }
  // heartbeat_ms 0: none.
  void apply(uint16_t heartbeat_ms, uint16_t status_ms, uint64_t now_ns) {
    heartbeat.start(now_ns + uint64_t{heartbeat_ms} * 1000000, uint64_t{heartbeat_ms} * 1000000);
    status.start(now_ns, uint64_t{status_ms} * 1000000);
  }
};

}  // namespace firmware

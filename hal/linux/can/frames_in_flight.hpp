// Frames of one identifier between the kernel's queue and the bus. A raw CAN socket calls a frame sent once it is queued; on a bus that
// is dead it lies there, and goes out when the bus comes back, however old it is. The kernel gives a socket its own frames back when
// they have been on the bus: what has not come back is in flight, and no more than two are let go there at a time.
#pragma once
#include <cstdint>

namespace hal {

class FramesInFlight {
 public:
  // Two: while one is on the bus the next may wait behind it, so that a frame each sample loses none.
  static constexpr int kMost = 2;
  // On a bus that lives an urgent frame waits for a few others, 0.1 ms each: one that has not come back by now was dropped.
  static constexpr uint64_t kDropped_ns = 100000000;

  bool full() const { return count_ >= kMost; }
  void sent(uint64_t now_ns) {
    ++count_;
    newest_ns_ = now_ns;
  }
  void came_back() { count_ -= count_ > 0 ? 1 : 0; }
  // Another node's frame has come: the bus lives.
  void bus_lives(uint64_t now_ns) {
    if (now_ns > newest_ns_ + kDropped_ns) count_ = 0;
  }
  // After a restart from bus-off, or an interface that went down: the driver has dropped what it had.
  void dropped() { count_ = 0; }

 private:
  int count_ = 0;
  uint64_t newest_ns_ = 0;
};

}  // namespace hal

// The kernel's monotonic clock, and what relates the time stamps of its drivers to it.
#pragma once
#include <time.h>

#include "hal/interface/clock.hpp"

namespace hal {

inline uint64_t to_ns(const timespec& time) {
  return static_cast<uint64_t>(time.tv_sec) * 1000000000u + static_cast<uint64_t>(time.tv_nsec);
}

inline uint64_t read_clock_ns(clockid_t clock) {
  timespec time{};
  ::clock_gettime(clock, &time);
  return to_ns(time);
}

constexpr uint64_t kLongestInABuffer_ns = 2000000000;  // of a board that keeps up with its samples

// CAN frames are stamped with the time of day. Returns that moment on the monotonic clock. A clock that was just set (a board
// without a battery learns the time of day from the network) gives stamps of the future or of long ago: they become now.
inline uint64_t monotonic_from_time_of_day_ns(uint64_t stamp_ns) {
  const uint64_t day_ns = read_clock_ns(CLOCK_REALTIME);
  const uint64_t now_ns = read_clock_ns(CLOCK_MONOTONIC);
  const uint64_t age_ns = day_ns > stamp_ns ? day_ns - stamp_ns : 0;
  return age_ns < now_ns && age_ns <= kLongestInABuffer_ns ? now_ns - age_ns : now_ns;
}

class LinuxClock final : public MonotonicClock {
 public:
  uint64_t now_ns() override { return read_clock_ns(CLOCK_MONOTONIC); }
};

}  // namespace hal

// The wire itself: is anybody there, how much is going on, how often was it away.
#pragma once
#include <cstdint>
#include <deque>
#include <string>

#include "host_sim/can_log/candump_line.hpp"

namespace live {

enum class BusPhase {
  kWaiting,  // nothing has come yet
  kUp,
  kSilent,  // no frame for kSilence_ns
  kOff,     // the bus controller has switched itself off
  kDown,    // the interface is down or gone
};

struct BitRates {
  int64_t nominal_bit_s = 500000;
  int64_t data_bit_s = 2000000;  // CAN FD
};

class BusLink {
 public:
  static constexpr uint64_t kSilence_ns = 1000000000;  // a controller says something ten times a second
  static constexpr uint64_t kLoadSpan_ns = 1000000000;

  explicit BusLink(const BitRates& rates) : rates_(rates) {}

  // Each returns what there is to tell ("bus back after 3.2 s"), mostly nothing.
  std::string take(const can_log::LogEntry& entry);
  std::string advance(uint64_t now_ns);  // nothing came until now
  std::string went_down(uint64_t now_ns);

  uint64_t last_frame_ns() const { return last_frame_ns_; }
  BusPhase phase() const { return phase_; }
  uint64_t phase_since_ns() const { return since_ns_; }
  uint64_t frames() const { return frames_; }
  uint64_t error_frames() const { return error_frames_; }
  int absences() const { return absences_; }
  // Over the last second: frames a second, and the part of the bus they took, at most (every possible stuff bit), in %.
  double frames_per_s() const;
  double load_percent() const;

 private:
  struct Passed {
    uint64_t time_ns = 0;
    int64_t duration_ns = 0;
  };
  std::string leave(BusPhase phase, uint64_t since_ns, const std::string& words);
  std::string come_back(uint64_t now_ns);
  void forget_before(uint64_t now_ns);

  BitRates rates_;
  BusPhase phase_ = BusPhase::kWaiting;
  uint64_t since_ns_ = 0, last_frame_ns_ = 0, now_ns_ = 0;
  uint64_t first_frame_ns_ = 0;  // since times last jumped back
  uint64_t frames_ = 0, error_frames_ = 0;
  int absences_ = 0;
  std::deque<Passed> passed_;
};

// At most: with every stuff bit that the standard allows, and the pause behind the frame.
int64_t longest_duration_ns(const hal::CanFrame& frame, const BitRates& rates);

}  // namespace live

// Frames into a candump log, in the order given.
#pragma once
#include <ostream>
#include <string>

#include "host_sim/can_log/candump_line.hpp"

namespace can_log {

// Simulated time starts at 0, but log2asc takes a log whose first second is 0 for one that has not begun: a simulated
// log adds this to its times. The digits after the billion are then seconds since the start.
constexpr uint64_t kSimulatedEpoch_s = 1000000000;

// A line of a simulated log, without the newline.
std::string simulated_line(const hal::CanFrame& frame, std::string_view interface);

class LogWriter {
 public:
  LogWriter(std::ostream& output, std::string interface, uint64_t epoch_s = 0)
      : output_(output), interface_(std::move(interface)), epoch_ns_(epoch_s * 1000000000u) {}
  void write(const hal::CanFrame& frame);  // at the epoch + frame.time_ns
  void write(const firmware::CanFrame& message, uint64_t time_ns);
  uint64_t frames() const { return frames_; }

 private:
  std::ostream& output_;
  std::string interface_;
  uint64_t epoch_ns_;
  uint64_t frames_ = 0;
};

}  // namespace can_log

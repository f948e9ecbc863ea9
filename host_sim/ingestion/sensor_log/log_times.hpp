// What the times of a log's frames are: of the clock, differences from frame to frame (candump -t d), or none (candump as it is).
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "host_sim/can_log/candump_line.hpp"

namespace host_sim {

class LogTimes {
 public:
  void learn(const can_log::LogEntry& entry);
  // After the last frame.
  bool none() const { return frames_ == 0; }
  bool differences() const;
  // Whether what stands in the lines says when the frames came.
  bool tell() const { return !none() && !differences(); }
  // Throws DataFileError where they do not, unless the user's rate stands for them.
  void require(const std::string& file, double sample_rate_Hz) const;

 private:
  uint64_t last_ns_ = 0, latest_ns_ = 0;
  size_t frames_ = 0, rises_ = 0, falls_ = 0,
         records_ = 0;  // with a time; later or earlier than the frame before; than all before
};

}  // namespace host_sim

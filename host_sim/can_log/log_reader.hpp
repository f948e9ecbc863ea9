// Frames out of a candump text or a Vector .asc log, whatever else stands in it.
#pragma once
#include <cstdint>
#include <istream>
#include <string>

#include "host_sim/can_log/asc_line.hpp"

namespace can_log {

class LogReader {
 public:
  explicit LogReader(std::istream& input) : input_(input) {}
  // The next frame; false at the end. Lines that are no frame are passed over and counted; empty lines are not counted.
  bool next(LogEntry& entry);
  uint64_t frames() const { return frames_; }
  uint64_t skipped() const { return skipped_; }
  uint64_t line() const { return line_; }                              // number of the last line read, from 1
  uint64_t first_skipped_line() const { return first_skipped_line_; }  // 0: none was skipped

 private:
  bool next_line();

  std::istream& input_;
  std::string text_;
  AscLog asc_;
  bool too_long_ = false;
  uint64_t frames_ = 0, skipped_ = 0, line_ = 0, first_skipped_line_ = 0;
};

}  // namespace can_log

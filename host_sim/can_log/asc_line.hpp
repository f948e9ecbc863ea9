// Lines of Vector's ASCII logs (.asc):
//   date Sun Nov 22 07:00:00.000 am 2026
//   base hex  timestamps absolute
//      0.001250 1  123             Rx   d 8 11 22 33 44 55 66 77 88
//      0.002250 1  18FF0102x       Tx   d 2 0A 0B
//      0.003000 CANFD   1 Rx        123  Name   1 0 9 12 11 22 33 44 55 66 77 88 99 AA BB CC 130000 ...
#pragma once
#include <string_view>

#include "host_sim/can_log/candump_line.hpp"

namespace can_log {

// Reads a log line by line: the lines at its head say in which base the numbers stand and from where times count.
class AscLog {
 public:
  // True where the line is a data frame; false for the log's other lines and for what is none of it.
  bool parse(std::string_view line, LogEntry& entry);

 private:
  bool take_header(std::string_view line);
  int base_ = 16;
  bool relative_ = false;
  uint64_t last_ns_ = 0;
};

// Does a text begin as such a log does?
bool is_asc_log(std::string_view content);

}  // namespace can_log

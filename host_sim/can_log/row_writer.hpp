// Readings as rows for awk, a database or a plot: CSV, or one JSON object a line. The columns are fixed:
//   time_s, interface, sender, frame, name, value, std, unit, status
// value and std are empty (JSON: null) where there is none; no text contains a comma or a quote.
#pragma once
#include <map>
#include <ostream>
#include <string>

#include "host_sim/can_log/readings.hpp"

namespace can_log {

enum class RowFormat { kCsv, kJson };

class RowWriter {
 public:
  RowWriter(std::ostream& output, RowFormat format, bool changes_only);  // CSV: writes the head
  // False where the frame is not of this protocol.
  bool write(const LogEntry& entry);

 private:
  std::ostream& output_;
  RowFormat format_;
  bool changes_only_;
  FrameReader reader_;
  std::map<std::string, std::string> last_;  // what each name said last, where only changes are wanted
};

}  // namespace can_log

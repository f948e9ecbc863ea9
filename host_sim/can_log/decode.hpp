// candump text to lines that a person reads:
//           0.050000  vcan0  node 1  estimate         viscous[1-2] = 20.00123 N s/m   std 0.012 (0.06 %)   VALID
#pragma once
#include <cstdint>
#include <istream>
#include <ostream>

namespace can_log {

struct DecodeSummary {
  uint64_t frames = 0;
  uint64_t foreign_frames = 0;  // not of this protocol; shown by their bytes
  uint64_t skipped_lines = 0;   // no frame at all
};

enum class DecodeFormat { kLines, kCsv, kJson };

struct DecodeOptions {
  DecodeFormat format = DecodeFormat::kLines;
  bool changes_only = false;  // leave out what says the same as the line of this signal before it
};

// Writes one line per signal (row_writer.hpp: CSV and JSON) as frames come (so a live bus can be piped through). An estimate is one line: name, value,
// unit, standard deviation, status. Lines that are no frames are counted, and their number is named on `messages` at
// the end.
DecodeSummary decode(std::istream& input, std::ostream& output, std::ostream& messages, DecodeOptions options = {});

}  // namespace can_log

#include "host_sim/can_log/decode.hpp"

#include "host_sim/can_log/frame_printer.hpp"
#include "host_sim/can_log/log_reader.hpp"

namespace can_log {

DecodeSummary decode(std::istream& input, std::ostream& output, std::ostream& messages, DecodeOptions options) {
  LogReader reader(input);
  FramePrinter printer(output, options.changes_only);
  DecodeSummary summary;
  LogEntry entry;
  while (reader.next(entry)) {
    if (!printer.print(entry)) ++summary.foreign_frames;
    if (input.rdbuf()->in_avail() <= 0) output.flush();  // nothing waits: a live bus, let the reader see it
    if (!output) break;
  }
  output.flush();
  summary.frames = reader.frames();
  summary.skipped_lines = reader.skipped();
  if (summary.skipped_lines > 0) {
    messages << "decode: " << summary.skipped_lines << " of " << summary.skipped_lines + summary.frames
             << " lines skipped: no candump frame (the first is line " << reader.first_skipped_line() << ")\n";
  }
  return summary;
}

}  // namespace can_log

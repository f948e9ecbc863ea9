#include "host_sim/can_log/decode.hpp"

#include "host_sim/can_log/frame_printer.hpp"
#include "host_sim/can_log/log_reader.hpp"
#include "host_sim/can_log/row_writer.hpp"

namespace can_log {

namespace {

template <typename Output>
void decode_all(std::istream& input, std::ostream& output, LogReader& reader, DecodeSummary& summary, Output write) {
  LogEntry entry;
  while (reader.next(entry)) {
    if (!write(entry)) ++summary.foreign_frames;
    if (input.rdbuf()->in_avail() <= 0) output.flush();  // nothing waits: a live bus, let the reader see it
    if (!output) break;
  }
}

}  // namespace

DecodeSummary decode(std::istream& input, std::ostream& output, std::ostream& messages, DecodeOptions options) {
  LogReader reader(input);
  DecodeSummary summary;
  if (options.format == DecodeFormat::kLines) {
    FramePrinter printer(output, options.changes_only);
    decode_all(input, output, reader, summary, [&](const LogEntry& entry) { return printer.print(entry); });
  } else {
    const RowFormat format = options.format == DecodeFormat::kCsv ? RowFormat::kCsv : RowFormat::kJson;
    RowWriter writer(output, format, options.changes_only);
    decode_all(input, output, reader, summary, [&](const LogEntry& entry) { return writer.write(entry); });
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

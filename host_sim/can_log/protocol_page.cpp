#include "host_sim/can_log/protocol_page.hpp"

#include <sstream>

#include "firmware/can_protocol/frame_table.hpp"
#include "firmware/can_protocol/load/bus_load.hpp"
#include "host_sim/can_log/readable.hpp"
#include "host_sim/can_log/table_text.hpp"

namespace can_log {

const char* const kGeneratedBegin =
    "<!-- generated from firmware/can_protocol/frame_table.hpp by can_protocol_page -->\n";
const char* const kGeneratedEnd = "<!-- end of the generated part -->\n";

namespace {

namespace can = firmware::can;
using can::FrameDescription;
using can::Signal;

std::string id_formula(const FrameDescription& frame) {
  const can::IdPlan& ids = frame.ids;
  const uint32_t lowest = can::frame_id(ids, 0);
  if (frame.sender == can::Sender::kSensor) return hex_text(lowest - 1, 3) + " + d";
  std::string text = hex_text(lowest, 3);
  if (ids.node_stride == 1) text += " + n";
  if (ids.node_stride > 1) text += " + " + std::to_string(ids.node_stride) + " n";
  if (ids.members == 1) return text;
  if (ids.members <= ids.bank_members) return text + " + j";
  text += " + {";
  for (int bank = 0; bank < can::bank_count(ids); ++bank)
    text += (bank > 0 ? ", " : "") + (ids.bank_offset[bank] > 0 ? hex_text(ids.bank_offset[bank], 2) : "0");
  const std::string size = std::to_string(ids.bank_members);
  return text + "}[k div " + size + "] + (k mod " + size + ")";
}

std::string id_range(const FrameDescription& frame) {
  const bool per_node = frame.ids.node_stride > 0;
  const uint32_t first = can::frame_id(frame.ids, per_node ? can::kFirstNode : 0);
  const uint32_t last = can::frame_id(frame.ids, per_node ? can::kLastNode : 0, frame.ids.members - 1);
  return first == last ? hex_text(first, 3) : hex_text(first, 3) + " to " + hex_text(last, 3);
}

const char* sender_word(const FrameDescription& frame) {
  switch (frame.sender) {
    case can::Sender::kController:
      return "controller";
    case can::Sender::kSensor:
      return "sensor";
    case can::Sender::kMaster:
      break;
  }
  return "master";
}

void identifier_table(std::ostream& output) {
  output << "### Identifiers\n\nn is the node (1 to 7), d the DOF (1 to 16, 17 for the moving base), k the index of an "
            "estimate (0 to 47), j a frame of eight estimates (0 to 5).\n\n"
            "| identifier | all of them | frame | from | bytes | when |\n|---|---|---|---|---|---|\n";
  for (const FrameDescription* frame : can::kFrames) {
    output << "| " << id_formula(*frame) << " | " << id_range(*frame) << " | `" << frame->name << "` | "
           << sender_word(*frame) << " | " << static_cast<int>(frame->length) << (frame->fd ? " (FD)" : "") << " | "
           << frame->when << " |\n";
  }
  output << "\n";
}

std::string value_column(const Signal& signal) {
  if (signal.names.count == 0) return "";
  std::string text;
  for (int i = 0; i < signal.names.count; ++i) {
    if (i > 0) text += ", ";
    const can::NamedValue& entry = signal.names.entries[i];
    const bool code = signal.length == 16 || &signal.names.entries[0] == &can::kSdoCommands[0];
    text += (signal.names.flags ? "bit " + std::to_string(entry.value)
             : code             ? hex_text(static_cast<uint64_t>(entry.value), signal.length / 4)
                                : std::to_string(entry.value)) +
            " " + entry.name;
  }
  return text;
}

std::string scale_column(const Signal& signal) {
  std::string text = signal.unit;
  if (signal.factor_denominator != 1) text = shortest(factor(signal)) + (text == "1" ? "" : " " + text);
  if (signal.offset != 0)
    text += signal.offset < 0 ? ", less " + std::to_string(-signal.offset) : ", plus " + std::to_string(signal.offset);
  return text;
}

void frame_section(std::ostream& output, const FrameDescription& frame) {
  output << "### `" << frame.name << "` " << id_range(frame) << "\n\n" << frame.comment << "\n\n";
  if (frame.signal_count == 0) return;
  if (frame.repeats > 1)
    output << static_cast<int>(frame.repeats) << " records of " << can::record_bits(frame) / 8
           << " bytes, each laid out as "
           << (&frame == &can::kEstimateFd ? "`estimate`; an unused record has the value -2147483648 and is STALE.\n\n"
                                           : "`estimate_float`; an unused record is not a number.\n\n");
  if (frame.repeats > 1) return;
  output << "| bits | type | unit | signal | meaning | values |\n|---|---|---|---|---|---|\n";
  for (int i = 0; i < frame.signal_count; ++i) {
    const Signal& signal = frame.signals[i];
    output << "| " << signal.start_bit << " to " << signal.start_bit + signal.length - 1 << " | "
           << (signal.is_signed ? "i" : "u") << static_cast<int>(signal.length) << " | " << scale_column(signal)
           << " | `" << signal.name << "` | " << signal.comment << " | " << value_column(signal) << " |\n";
  }
  output << "\n";
}

void load_row(std::ostream& output, const char* what, const FrameDescription& frame, int frames, int64_t period_us) {
  const auto percent = [&](int64_t nominal, int64_t data) {
    return shortest(static_cast<double>(can::load_permille(frame, frames, period_us, nominal, data)) / 10.0) + " %";
  };
  output << "| " << what << " | " << frames << " | "
         << (frame.fd ? std::string("- | - | ") + percent(500000, 2000000) + " | " + percent(1000000, 5000000)
                      : percent(500000, 500000) + " | " + percent(1000000, 1000000) + " | - | -")
         << " |\n";
}

void load_table(std::ostream& output) {
  output << "### Bus load at worst (every possible stuff bit)\n\n"
            "| stream | frames each time | 500 kbit/s | 1 Mbit/s | FD 500 k / 2 M | FD 1 M / 5 M "
            "|\n|---|---|---|---|---|---|\n";
  load_row(output, "48 estimates and their window frame, each 50 ms", can::kEstimate, 49, 50000);
  load_row(output, "5 estimates and their window frame, each 50 ms", can::kEstimate, 6, 50000);
  load_row(output, "48 estimates, CAN FD, each 50 ms", can::kEstimateFd, 6, 50000);
  load_row(output, "5 estimates once more as floats, each 50 ms", can::kEstimateFloat, 5, 50000);
  load_row(output, "48 estimates once more as floats, each 1 s", can::kEstimateFloat, 48, 1000000);
  load_row(output, "48 names, each 1 s", can::kParameter, 48, 1000000);
  load_row(output, "status, each 100 ms", can::kStatus, 1, 100000);
  load_row(output, "one DOF, 16 bits without force, 1 kHz", can::kSensorMotion16, 1, 1000);
  load_row(output, "one DOF, 24 bits with all channels, 1 kHz", can::kSensorMotion24, 2, 1000);
  load_row(output, "one DOF, CAN FD, 1 kHz", can::kSensorFd, 1, 1000);
  load_row(output, "three DOFs, CAN FD, 1 kHz", can::kSensorFd, 3, 1000);
  load_row(output, "drive command, 1 kHz", can::kDrive, 1, 1000);
  output << "\n";
}

}  // namespace

void protocol_tables(std::ostream& output) {
  identifier_table(output);
  load_table(output);
  for (const FrameDescription* frame : can::kFrames) frame_section(output, *frame);
}

std::string renewed_page(const std::string& page) {
  const size_t begin = page.find(kGeneratedBegin), end = page.find(kGeneratedEnd);
  if (begin == std::string::npos || end == std::string::npos || end < begin) return "";
  std::ostringstream tables;
  protocol_tables(tables);
  return page.substr(0, begin) + kGeneratedBegin + "\n" + tables.str() + page.substr(end);
}

}  // namespace can_log

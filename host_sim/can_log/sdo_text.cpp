#include "host_sim/can_log/sdo_text.hpp"

#include "firmware/can_protocol/messages/packing.hpp"
#include "host_sim/can_log/readable.hpp"

namespace can_log {
namespace {

constexpr firmware::can::NamedValue kAbortCodes[] = {{0x05030000, "toggle bit not alternated"},
                                                     {0x05040001, "unknown command"},
                                                     {0x06010002, "read only"},
                                                     {0x06020000, "no such object"},
                                                     {0x06060000, "hardware error"},
                                                     {0x06070010, "wrong length"},
                                                     {0x06090011, "no such subindex"},
                                                     {0x06090032, "value too low"},
                                                     {0x08000020, "cannot be stored, or wrong signature"},
                                                     {0x08000022, "not in this state"}};

struct Sdo {
  int command;
  int64_t data;
  std::string object;  // "device_name (1008.0)"
};

Sdo read_sdo(const firmware::CanFrame& message) {
  const auto raw = [&](int i) { return firmware::can::get_raw(message, firmware::can::kSdoSignals[i]); };
  const std::string name = state_name(firmware::can::states(firmware::can::kSdoObjects), raw(1));
  const std::string address = hex_text(static_cast<uint64_t>(raw(1)), 4).substr(2) + "." + std::to_string(raw(2));
  return Sdo{static_cast<int>(raw(0)), raw(3), name.empty() ? "object " + address : name + " (" + address + ")"};
}

// The bytes where all of them are letters: "save", "0.1.0".
std::string quoted(const firmware::CanFrame& message, int first, int count) {
  std::string text;
  for (int i = first; i < first + count; ++i) {
    if (message.data[i] < 0x20 || message.data[i] > 0x7E) return "";
    text += static_cast<char>(message.data[i]);
  }
  return text.empty() ? "" : "'" + text + "'";
}

// The value of an expedited transfer, of as many bytes as its command says.
std::string value_text(const firmware::CanFrame& message, const Sdo& sdo) {
  const int bytes = (sdo.command & 1) != 0 ? 4 - ((sdo.command >> 2) & 3) : 4;
  const int64_t value = bytes == 4 ? sdo.data : sdo.data & ((int64_t{1} << (8 * bytes)) - 1);
  const std::string text = quoted(message, 4, bytes);
  return std::to_string(value) + " (" + hex_text(static_cast<uint64_t>(value), 2 * bytes) + ")" +
         (text.empty() ? "" : " " + text);
}

std::string abort_text(const Sdo& sdo) {
  const std::string reason = state_name(firmware::can::states(kAbortCodes), sdo.data);
  return "abort of " + sdo.object + ": " + hex_text(static_cast<uint64_t>(sdo.data), 8) +
         (reason.empty() ? "" : " " + reason);
}

}  // namespace

std::string sdo_request_text(const firmware::CanFrame& message) {
  const Sdo sdo = read_sdo(message);
  if (sdo.command == 0x80) return abort_text(sdo);
  if (sdo.command == 0x40) return "read " + sdo.object;
  if ((sdo.command & 0xEF) == 0x60) return "read on";
  if ((sdo.command & 0xE2) == 0x22) return "write " + sdo.object + " = " + value_text(message, sdo);
  return "command " + hex_text(static_cast<uint64_t>(sdo.command), 2) + " on " + sdo.object;
}

std::string sdo_reply_text(const firmware::CanFrame& message) {
  const Sdo sdo = read_sdo(message);
  if (sdo.command == 0x80) return abort_text(sdo);
  if (sdo.command == 0x60) return sdo.object + " written";
  if (sdo.command == 0x41) return sdo.object + " has " + std::to_string(sdo.data) + " characters";
  if ((sdo.command & 0xE2) == 0x42) return sdo.object + " = " + value_text(message, sdo);
  if ((sdo.command & 0xE0) == 0x00) return "part = " + quoted(message, 1, 7 - ((sdo.command >> 1) & 7));
  return "command " + hex_text(static_cast<uint64_t>(sdo.command), 2) + " on " + sdo.object;
}

}  // namespace can_log

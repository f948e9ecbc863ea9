#include "host_sim/can_log/readable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "host_sim/can_log/table_text.hpp"

namespace can_log {
namespace {

struct BitName {
  uint32_t bit;
  const char* name;
};
// linux/can/error.h: error classes in the identifier, controller states in data[1].
constexpr BitName kErrorClasses[] = {{0x001, "transmit timeout"},
                                     {0x002, "lost arbitration"},
                                     {0x004, "controller problem"},
                                     {0x008, "protocol violation"},
                                     {0x010, "transceiver fault"},
                                     {0x020, "no acknowledgement"},
                                     {0x040, "bus-off"},
                                     {0x080, "bus error"},
                                     {0x100, "controller restarted"},
                                     {0x200, "error counters"}};
constexpr BitName kControllerStates[] = {{0x01, "receive overflow"},      {0x02, "transmit overflow"},
                                         {0x04, "receive error warning"}, {0x08, "transmit error warning"},
                                         {0x10, "receive error passive"}, {0x20, "transmit error passive"},
                                         {0x40, "error active again"}};

template <size_t N>
std::string list_bits(const BitName (&names)[N], uint32_t bits) {
  std::string text;
  for (const BitName& entry : names) {
    if ((bits & entry.bit) == 0) continue;
    if (!text.empty()) text += ", ";
    text += entry.name;
  }
  return text;
}

}  // namespace

std::string number_text(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }

std::string rounded_to(double value, double uncertainty) {
  if (value == 0.0 || !(uncertainty > 0.0)) return number_text(value, 7);
  const int top = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const int last = static_cast<int>(std::floor(std::log10(uncertainty))) - 1;
  const int digits = std::clamp(top - last + 1, 3, 9);
  if (top < -4 || top > 8) return number_text(value, digits);
  return fmt::format("{:.{}f}", value, std::max(0, digits - 1 - top));
}

double times_power_of_ten(double mantissa, int exponent) {
  return exponent < 0 ? mantissa / std::pow(10.0, -exponent) : mantissa * std::pow(10.0, exponent);
}

float float_of_bits(int64_t bits) {
  const auto pattern = static_cast<uint32_t>(bits);
  float value = 0;
  std::memcpy(&value, &pattern, sizeof value);
  return value;
}

std::string hex_text(uint64_t value, int digits) { return fmt::format("0x{:0{}X}", value, digits); }

std::string bytes_text(const hal::CanFrame& frame) {
  std::string text;
  for (int i = 0; i < frame.length && i < 64; ++i) {
    text += fmt::format(i == 0 ? "{:02X}" : " {:02X}", frame.data[i]);
  }
  return text;
}

std::string state_name(const firmware::can::ValueTable& names, int64_t raw) {
  for (int i = 0; i < names.count; ++i)
    if (names.entries[i].value == raw) return names.entries[i].name;
  return "";
}

std::string flag_names(const firmware::can::ValueTable& names, int64_t raw) {
  std::string text;
  for (int bit = 0; bit < 32; ++bit) {
    if ((raw >> bit & 1) == 0) continue;
    const std::string name = state_name(names, bit);
    if (!text.empty()) text += " | ";
    text += name.empty() ? "bit " + std::to_string(bit) : name;
  }
  return text.empty() ? "none" : text;
}

std::string signal_text(const firmware::can::Signal& signal, int64_t raw) {
  if (signal.names.flags) return flag_names(signal.names, raw);
  const std::string name = state_name(signal.names, raw);
  if (!name.empty()) return name;
  const std::string unit = signal.unit;
  if (unit == "hex") return hex_text(static_cast<uint64_t>(raw), signal.length / 4);
  if (unit == "DOF") return "DOF " + std::to_string(raw);
  const std::string number = signal.factor_denominator == 1
                                 ? std::to_string(raw * signal.factor_numerator + signal.offset)
                                 : number_text(physical(signal, raw), 9);
  return unit == "1" || unit == "state" ? number : number + " " + unit;
}

std::string error_frame_text(const hal::CanFrame& frame) {
  std::string text = list_bits(kErrorClasses, frame.id);
  const std::string controller = (frame.id & 0x004) != 0 ? list_bits(kControllerStates, frame.data[1]) : "";
  if (!controller.empty()) text += " (" + controller + ")";
  return text.empty() ? "no class given" : text;
}

}  // namespace can_log

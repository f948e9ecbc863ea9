#include "host_sim/records/csv/csv_writer.hpp"

#include <array>
#include <charconv>

namespace host_sim {
namespace {

using Text = std::array<char, 48>;

void append_shortest(std::string& text, double value) {
  Text digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

// Nanoseconds of a day: 14 digits; more would show the rounding of i * sample_period.
void append_time(std::string& text, double value) {
  Text digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 14).ptr;
  text.append(digits.data(), end);
}

}  // namespace

std::string format_csv(const Record& record) {
  std::string text = "t_s";
  for (const Channel& channel : record.channels) text += "," + channel.name;
  text += "\n";
  const size_t samples = record.samples();
  text.reserve(text.size() + samples * (record.channels.size() + 1) * 20);
  for (size_t i = 0; i < samples; ++i) {
    append_time(text, record.start_s + static_cast<double>(i) * record.sample_period_s);
    for (const Channel& channel : record.channels) {
      text += ',';
      append_shortest(text, channel.values[i]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace host_sim

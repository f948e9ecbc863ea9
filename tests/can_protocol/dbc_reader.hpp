// A DBC reader for the tests, written from the format's description alone: line by line with regular expressions. It
// shares no code with the writer.
#pragma once
#include <cstdint>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace dbc_reader {

struct Signal {
  std::string name;
  int start = 0, length = 0;
  bool little_endian = false, is_signed = false;
  double factor = 0, offset = 0, minimum = 0, maximum = 0;
  std::string unit, comment;
  std::map<int64_t, std::string> values;
};

struct Message {
  std::string name, sender, comment;
  int length = 0;
  int cycle_ms = -1;  // -1: no attribute
  bool fd = false;
  std::vector<Signal> signals;
  Signal* find(const std::string& signal_name) {
    for (Signal& signal : signals)
      if (signal.name == signal_name) return &signal;
    return nullptr;
  }
};

struct Dbc {
  std::map<uint32_t, Message> messages;
  std::vector<std::string> nodes;
  std::vector<std::string> faults;  // lines that could not be understood
};

inline void read_values(const std::string& text, Signal& signal) {
  static const std::regex pair("(-?[0-9]+) \"([^\"]*)\"");
  for (std::sregex_iterator it(text.begin(), text.end(), pair), end; it != end; ++it)
    signal.values[std::stoll((*it)[1])] = (*it)[2];
}

inline Dbc read(std::istream& input) {
  static const std::regex message_line("BO_ ([0-9]+) (\\w+): ([0-9]+) (\\w+)");
  static const std::regex signal_line(
      " SG_ (\\w+) : ([0-9]+)\\|([0-9]+)@([01])([+-]) \\(([^,]+),([^)]+)\\) \\[([^|]+)\\|([^\\]]+)\\] \"([^\"]*)\" "
      "(\\w+)");
  static const std::regex signal_comment("CM_ SG_ ([0-9]+) (\\w+) \"([^\"]*)\";");
  static const std::regex message_comment("CM_ BO_ ([0-9]+) \"([^\"]*)\";");
  static const std::regex cycle("BA_ \"GenMsgCycleTime\" BO_ ([0-9]+) ([0-9]+);");
  static const std::regex format("BA_ \"VFrameFormat\" BO_ ([0-9]+) ([0-9]+);");
  static const std::regex values("VAL_ ([0-9]+) (\\w+)((?: -?[0-9]+ \"[^\"]*\")+) ;");
  static const std::regex other("(VERSION|NS_|BS_|BA_DEF_|BA_DEF_DEF_|\\t).*|");
  Dbc dbc;
  std::string line;
  uint32_t current = 0;
  std::smatch m;
  const auto number = [&](int i) { return static_cast<uint32_t>(std::stoul(m[i])); };
  while (std::getline(input, line)) {
    if (std::regex_match(line, m, message_line)) {
      current = number(1);
      if (dbc.messages.count(current) != 0) dbc.faults.push_back("twice: " + line);
      Message& message = dbc.messages[current];
      message.name = m[2];
      message.length = static_cast<int>(number(3));
      message.sender = m[4];
    } else if (std::regex_match(line, m, signal_line)) {
      Signal signal;
      signal.name = m[1];
      signal.start = static_cast<int>(number(2));
      signal.length = static_cast<int>(number(3));
      signal.little_endian = m[4] == "1";
      signal.is_signed = m[5] == "-";
      signal.factor = std::stod(m[6]);
      signal.offset = std::stod(m[7]);
      signal.minimum = std::stod(m[8]);
      signal.maximum = std::stod(m[9]);
      signal.unit = m[10];
      if (dbc.messages[current].find(signal.name) != nullptr) dbc.faults.push_back("twice: " + line);
      dbc.messages[current].signals.push_back(signal);
    } else if (std::regex_match(line, m, message_comment)) {
      dbc.messages[number(1)].comment = m[2];
    } else if (std::regex_match(line, m, signal_comment) || std::regex_match(line, m, values)) {
      Signal* signal = dbc.messages[number(1)].find(m[2]);
      if (signal == nullptr) {
        dbc.faults.push_back("unknown signal: " + line);
      } else if (line[0] == 'C') {
        signal->comment = m[3];
      } else {
        read_values(m[3], *signal);
      }
    } else if (std::regex_match(line, m, cycle)) {
      dbc.messages[number(1)].cycle_ms = static_cast<int>(number(2));
    } else if (std::regex_match(line, m, format)) {
      dbc.messages[number(1)].fd = number(2) == 14;
    } else if (line.rfind("BU_:", 0) == 0) {
      std::istringstream names(line.substr(4));
      for (std::string name; names >> name;) dbc.nodes.push_back(name);
    } else if (!std::regex_match(line, m, other)) {
      dbc.faults.push_back(line);
    }
  }
  return dbc;
}

// Bits of a little-endian signal out of the bytes of a frame, taken bit by bit from the far end.
inline int64_t raw_value(const Signal& signal, const uint8_t* data) {
  uint64_t value = 0;
  for (int bit = signal.start + signal.length - 1; bit >= signal.start; --bit)
    value = value * 2 + ((data[bit / 8] / (1u << (bit % 8))) % 2);
  const uint64_t half = uint64_t{1} << (signal.length - 1);
  if (signal.is_signed && value >= half) return static_cast<int64_t>(value) - static_cast<int64_t>(2 * half);
  return static_cast<int64_t>(value);
}

inline double physical(const Signal& signal, const uint8_t* data) {
  return static_cast<double>(raw_value(signal, data)) * signal.factor + signal.offset;
}

}  // namespace dbc_reader

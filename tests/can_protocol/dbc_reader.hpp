// A DBC reader for the tests, written from the format's description alone, line by line. It shares no code with the
// writer.
#pragma once
#include <cstdint>
#include <cstdio>
#include <istream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace dbc_reader {

struct Signal {
  std::string name;
  int start = 0, length = 0;
  bool little_endian = false, is_signed = false, is_float = false;
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

class Reader {
 public:
  Dbc read(std::istream& input) {
    for (std::string line; std::getline(input, line);)
      if (!take(line.c_str())) dbc_.faults.push_back(line);
    return dbc_;
  }

 private:
  bool take(const char* line) {
    return message(line) || signal(line) || comment(line) || attribute(line) || values(line) || nodes(line) ||
           value_type(line) || other(line);
  }

  // %n is set only where everything before it matched; `end` then has to be the end of the line.
  bool message(const char* line) {
    char name[64], sender[64];
    unsigned id = 0;
    int length = 0, end = 0;
    if (std::sscanf(line, "BO_ %u %63[A-Za-z0-9_]: %d %63[A-Za-z0-9_]%n", &id, name, &length, sender, &end) != 4)
      return false;
    if (line[end] != '\0' || dbc_.messages.count(id) != 0) return false;
    current_ = &dbc_.messages[id];
    current_->name = name;
    current_->length = length;
    current_->sender = sender;
    return true;
  }

  bool signal(const char* line) {
    Signal s;
    char name[64], unit[64], receiver[64], order = 0, sign = 0;
    int end = 0;
    if (std::sscanf(line, " SG_ %63[A-Za-z0-9_] : %d|%d@%c%c (%lf,%lf) [%lf|%lf] \"%63[^\"]\" %63s%n", name, &s.start,
                    &s.length, &order, &sign, &s.factor, &s.offset, &s.minimum, &s.maximum, unit, receiver, &end) != 11)
      return false;
    if (line[end] != '\0' || current_ == nullptr || current_->find(name) != nullptr) return false;
    if ((order != '0' && order != '1') || (sign != '+' && sign != '-')) return false;
    s.name = name;
    s.unit = unit;
    s.little_endian = order == '1';
    s.is_signed = sign == '-';
    current_->signals.push_back(s);
    return true;
  }

  bool comment(const char* line) {
    unsigned id = 0;
    char name[64], text[512];
    int end = 0;
    if (std::sscanf(line, "CM_ BO_ %u \"%511[^\"]\";%n", &id, text, &end) == 2 && end > 0 && line[end] == '\0') {
      dbc_.messages[id].comment = text;
      return true;
    }
    end = 0;
    if (std::sscanf(line, "CM_ SG_ %u %63s \"%511[^\"]\";%n", &id, name, text, &end) != 3 || end == 0 ||
        line[end] != '\0')
      return false;
    Signal* found = dbc_.messages[id].find(name);
    if (found != nullptr) found->comment = text;
    return found != nullptr;
  }

  bool attribute(const char* line) {
    unsigned id = 0;
    int value = 0, end = 0;
    if (std::sscanf(line, "BA_ \"GenMsgCycleTime\" BO_ %u %d;%n", &id, &value, &end) == 2 && end > 0) {
      dbc_.messages[id].cycle_ms = value;
      return line[end] == '\0';
    }
    if (std::sscanf(line, "BA_ \"VFrameFormat\" BO_ %u %d;%n", &id, &value, &end) == 2 && end > 0) {
      dbc_.messages[id].fd = value == 14;
      return line[end] == '\0';
    }
    return false;
  }

  bool values(const char* line) {
    unsigned id = 0;
    char name[64], text[64];
    int end = 0, value = 0;
    if (std::sscanf(line, "VAL_ %u %63s%n", &id, name, &end) != 2) return false;
    Signal* found = dbc_.messages[id].find(name);
    if (found == nullptr) return false;
    line += end;
    for (; std::sscanf(line, " %d \"%63[^\"]\"%n", &value, text, &end) == 2; line += end) found->values[value] = text;
    return std::string(line) == " ;";
  }

  bool nodes(const char* line) {
    const std::string text = line;
    if (text.rfind("BU_:", 0) != 0) return false;
    std::istringstream names(text.substr(4));
    for (std::string name; names >> name;) dbc_.nodes.push_back(name);
    return true;
  }

  bool value_type(const char* line) {
    unsigned id = 0;
    int type = 0, end = 0;
    char name[64];
    if (std::sscanf(line, "SIG_VALTYPE_ %u %63[A-Za-z0-9_] : %d;%n", &id, name, &type, &end) != 3) return false;
    Signal* found = dbc_.messages[id].find(name);
    if (found == nullptr || type != 1 || line[end] != '\0') return false;
    found->is_float = true;
    return true;
  }

  static bool other(const std::string& line) {
    for (const char* start : {"VERSION ", "NS_ :", "\t", "BS_:", "BA_DEF_ ", "BA_DEF_DEF_ "})
      if (line.rfind(start, 0) == 0) return true;
    return line.empty();
  }

  Dbc dbc_;
  Message* current_ = nullptr;
};

inline Dbc read(std::istream& input) { return Reader().read(input); }

// Bits of a little-endian signal out of the bytes of a frame, taken bit by bit from the far end.
inline int64_t raw_value(const Signal& signal, const uint8_t* data) {
  uint64_t value = 0;
  for (int bit = signal.start + signal.length - 1; bit >= signal.start; --bit)
    value = value * 2 + ((data[bit / 8] / (1u << (bit % 8))) % 2);
  const uint64_t half = uint64_t{1} << (signal.length - 1);
  if (signal.is_signed && value >= half) return static_cast<int64_t>(value) - static_cast<int64_t>(2 * half);
  return static_cast<int64_t>(value);
}

// 1 bit sign, 8 bits exponent with a bias of 127, 23 bits fraction; not for subnormal or infinite numbers.
inline double float_value(const Signal& signal, const uint8_t* data) {
  Signal bits = signal;
  bits.is_signed = false;
  const int64_t raw = raw_value(bits, data);
  if (raw == 0) return 0.0;
  double value = 1.0 + static_cast<double>(raw % 8388608) / 8388608.0;
  for (int64_t e = raw / 8388608 % 256; e > 127; --e) value *= 2.0;
  for (int64_t e = raw / 8388608 % 256; e < 127; ++e) value /= 2.0;
  return raw >= int64_t{2147483648} ? -value : value;
}

inline double physical(const Signal& signal, const uint8_t* data) {
  return static_cast<double>(raw_value(signal, data)) * signal.factor + signal.offset;
}

}  // namespace dbc_reader

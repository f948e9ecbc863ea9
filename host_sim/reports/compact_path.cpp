#include "host_sim/reports/compact_path.hpp"

#include <cmath>
#include <cstdlib>

namespace host_sim::reports {
namespace {

// 12 -> "1.2", -5 -> "-.5", 30 -> "3"; with a blank in front where it would run into the number before.
void append_tenths(std::string& out, long tenths, bool first) {
  if (tenths >= 0 && !first) out += ' ';
  if (tenths < 0) out += '-';
  const long size = std::labs(tenths);
  if (size >= 10 || size == 0) out += std::to_string(size / 10);
  if (size % 10 != 0) out += "." + std::to_string(size % 10);
}

long tenths(double value) { return std::lround(10.0 * value); }

}  // namespace

std::string compact_path(const std::string& data) {
  std::string out;
  const char* at = data.c_str();
  long x = 0, y = 0;
  bool drawing = false;  // the last command was a line: its letter need not be repeated
  for (;;) {
    while (*at == ' ' || *at == '\t' || *at == '\n') ++at;
    if (*at == '\0') return out;
    if (*at == 'Z') {
      out += 'z';
      ++at;
      drawing = false;
      continue;
    }
    const char command = *at++;
    if (command != 'M' && command != 'L') return data;
    char* end = nullptr;
    const long next_x = tenths(std::strtod(at, &end));
    if (end == at || *end != ',') return data;
    at = end + 1;
    const long next_y = tenths(std::strtod(at, &end));
    if (end == at) return data;
    at = end;
    if (command == 'M') {
      out += 'M';
      append_tenths(out, next_x, true);
      append_tenths(out, next_y, false);
    } else {
      if (!drawing) out += 'l';
      append_tenths(out, next_x - x, !drawing);
      append_tenths(out, next_y - y, false);
    }
    drawing = command == 'L';
    x = next_x;
    y = next_y;
  }
}

std::string with_compact_paths(const std::string& svg) {
  static const std::string kOpen = " d='";
  std::string out;
  size_t done = 0;
  for (size_t at = svg.find(kOpen); at != std::string::npos; at = svg.find(kOpen, done)) {
    const size_t first = at + kOpen.size(), last = svg.find('\'', first);
    if (last == std::string::npos) break;
    out += svg.substr(done, first - done) + compact_path(svg.substr(first, last - first));
    done = last;
  }
  return out + svg.substr(done);
}

}  // namespace host_sim::reports

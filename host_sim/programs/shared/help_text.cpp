#include "host_sim/programs/shared/help_text.hpp"

#include <algorithm>
#include <sstream>

#include "host_sim/programs/shared/terminal.hpp"

namespace host_sim {
namespace {

constexpr size_t kMeanings = 30;  // the column where CLI11 begins what an option means

// Column where the continuation of a line begins.
size_t hang_of(const std::string& line) {
  const size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const size_t gap = line.find("  ", begin);
  const size_t text = gap == std::string::npos ? gap : line.find_first_not_of(' ', gap);
  if (text != std::string::npos) return text;
  const bool filled = begin > 0 && begin < kMeanings && line.size() > kMeanings && line[kMeanings - 1] == ' ';
  if (filled) return kMeanings;          // by an option that leaves one blank
  return begin > 4 ? begin : begin + 2;  // the meaning of an option, on a line of its own, keeps its column
}

}  // namespace

std::string broken_to(const std::string& text, int width) {
  const auto columns = static_cast<size_t>(width);
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) {
    const std::string indent(std::min(hang_of(line), columns / 2), ' ');
    while (line.size() > columns) {
      const size_t blank = line.rfind(' ', columns);
      if (blank == std::string::npos || blank <= indent.size()) break;  // a word that is longer than a line
      out += line.substr(0, line.find_last_not_of(' ', blank) + 1) + "\n";
      line = indent + line.substr(blank + 1);
    }
    out += line + "\n";
  }
  return out;
}

std::string HelpText::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  return broken_to(CLI::Formatter::make_help(app, std::move(name), mode), terminal_width(stdout));
}

}  // namespace host_sim

// Help that fits the terminal.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace host_sim {

// CLI11's own text with every line broken to the width of stdout's terminal (80 where there is none): what an option
// means continues in its column.
class HelpText : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

// `text` with lines of at most `width` columns. A line that has a gap of two blanks after its first words continues
// behind that gap, any other two columns further in than it began.
std::string broken_to(const std::string& text, int width);

}  // namespace host_sim

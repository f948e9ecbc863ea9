// What only a terminal gets: colours and a progress bar. In a pipe or a file both are silent.
#pragma once
#include <cstdio>
#include <string>

namespace host_sim {

enum class Colour { kGood, kDoubtful, kBad, kQuiet, kBold };

// Columns for text on this stream: COLUMNS where it is set, else the terminal's, else 80; 60 to 200.
int terminal_width(std::FILE* stream);
// Columns at which sentences are wrapped: terminal_width() on a terminal or where COLUMNS is set, else 0: in a file or a
// pipe a sentence stays on one line.
int wrap_width(std::FILE* stream);
// A sentence on lines of at most `width` columns, broken at blanks; later lines begin with `indent`. width 0: one line.
std::string wrapped(const std::string& text, int width, const std::string& indent = "");
bool unicode_locale();  // the user's locale writes UTF-8

bool is_terminal(std::FILE* stream);  // and colours are wanted: NO_COLOR unset, TERM not dumb
std::string coloured(const std::string& text, Colour colour, bool on);

// One line on stderr that fills up; erased when it ends.
class ProgressBar {
 public:
  explicit ProgressBar(std::string label);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  void show(double share);  // 0 to 1

 private:
  std::string label_;
  bool on_;
  int shown_ = -1;
};

}  // namespace host_sim

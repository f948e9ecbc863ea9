#include "host_sim/programs/shared/terminal.hpp"

#include <langinfo.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <cstring>

namespace host_sim {

int terminal_width(std::FILE* stream) {
  constexpr int kDefault = 80, kFewest = 60, kMost = 200;
  const char* given = std::getenv("COLUMNS");
  winsize size{};
  int columns = given != nullptr ? std::atoi(given) : 0;
  if (columns <= 0 && ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0) columns = size.ws_col;
  return std::clamp(columns > 0 ? columns : kDefault, kFewest, kMost);
}

int wrap_width(std::FILE* stream) {
  return std::getenv("COLUMNS") != nullptr || ::isatty(::fileno(stream)) != 0 ? terminal_width(stream) : 0;
}

std::string wrapped(const std::string& text, int width, const std::string& indent) {
  if (width <= 0) return text;
  std::string out;
  int column = 0;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const int length = static_cast<int>(
        std::count_if(word.begin(), word.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
    if (column > 0 && column + 1 + length > width) {
      out += "\n" + indent;
      column = static_cast<int>(indent.size());
    } else if (begin > 0) {
      out += " ";
      ++column;
    }
    out += word;
    column += length;
    begin = end + 1;
  }
  return out;
}

bool unicode_locale() {
  std::setlocale(LC_CTYPE, "");
  return std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
}

bool is_terminal(std::FILE* stream) {
  const char* term = std::getenv("TERM");
  const char* no_color = std::getenv("NO_COLOR");
  if (no_color != nullptr && *no_color != '\0') return false;
  return ::isatty(::fileno(stream)) != 0 && term != nullptr && std::strcmp(term, "dumb") != 0;
}

std::string coloured(const std::string& text, Colour colour, bool on) {
  if (!on) return text;
  const char* code = "0";
  switch (colour) {
    case Colour::kGood:
      code = "32";
      break;
    case Colour::kDoubtful:
      code = "33";
      break;
    case Colour::kBad:
      code = "31";
      break;
    case Colour::kQuiet:
      code = "2";
      break;
    case Colour::kBold:
      code = "1";
      break;
  }
  return std::string("\033[") + code + "m" + text + "\033[0m";
}

ProgressBar::ProgressBar(std::string label) : label_(std::move(label)), on_(is_terminal(stderr)) {}

ProgressBar::~ProgressBar() {
  if (on_ && shown_ >= 0) std::fprintf(stderr, "\r\033[K");
}

void ProgressBar::show(double share) {
  constexpr int kWidth = 40;
  const int percent = static_cast<int>(100.0 * std::clamp(share, 0.0, 1.0));
  if (!on_ || percent == shown_) return;
  shown_ = percent;
  const int filled = percent * kWidth / 100;
  const std::string bar =
      std::string(static_cast<size_t>(filled), '#') + std::string(static_cast<size_t>(kWidth - filled), '.');
  std::fprintf(stderr, "\r%s [%s] %3d %%", label_.c_str(), bar.c_str(), percent);
  std::fflush(stderr);
}

}  // namespace host_sim

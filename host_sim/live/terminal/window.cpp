#include "host_sim/live/terminal/window.hpp"

#define NCURSES_NOMACROS  // its macros have names such as scroll and move
#include <curses.h>
#include <fcntl.h>
#include <langinfo.h>
#include <unistd.h>

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "host_sim/live/terminal/controls.hpp"

namespace live {
namespace {

constexpr short kGreen = 1, kYellow = 2, kRed = 3;

bool colours_wanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return (no_color == nullptr || *no_color == '\0') && has_colors();
}

chtype attribute_of(Role role, bool colours) {
  switch (role) {
    case Role::kPlain:
      break;
    case Role::kTitle:
      return A_REVERSE;
    case Role::kHead:
      return A_BOLD;
    case Role::kGood:
      return colours ? COLOR_PAIR(kGreen) : A_NORMAL;
    case Role::kDoubtful:
      return colours ? COLOR_PAIR(kYellow) : A_BOLD;
    case Role::kBad:
      return colours ? COLOR_PAIR(kRed) | A_BOLD : A_REVERSE;
    case Role::kQuiet:
      return A_DIM;
  }
  return A_NORMAL;
}

int translated(int key) {
  switch (key) {
    case ERR:
      return kKeyNone;
    case KEY_UP:
      return kKeyUp;
    case KEY_DOWN:
      return kKeyDown;
    case KEY_PPAGE:
      return kKeyPageUp;
    case KEY_NPAGE:
      return kKeyPageDown;
    case KEY_RESIZE:
      return kKeyResize;
    default:
      return key < 256 ? key : kKeyNone;
  }
}

}  // namespace

struct Window::Screen {
  std::FILE* input = nullptr;  // keys come from the terminal, whatever stdin is
  SCREEN* screen = nullptr;
  bool colours = false, unicode = false;
};

Window::Window() : screen_(std::make_unique<Screen>()) {
  std::setlocale(LC_CTYPE, "");
  screen_->unicode = std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
  screen_->input = std::fopen("/dev/tty", "r");
  if (screen_->input == nullptr) throw std::runtime_error("there is no terminal to read keys from; --once needs none");
  screen_->screen = newterm(nullptr, stdout, screen_->input);
  if (screen_->screen == nullptr) {
    std::fclose(screen_->input);
    const char* term = std::getenv("TERM");
    throw std::runtime_error("TERM is \"" + std::string(term == nullptr ? "" : term) +
                             "\", expected a terminal that ncurses knows; --once needs none");
  }
  set_term(screen_->screen);
  raw();  // ctrl-C is a key: the terminal is given back first
  noecho();
  nonl();
  keypad(stdscr, TRUE);
  nodelay(stdscr, TRUE);
  set_escdelay(25);
  curs_set(0);
  screen_->colours = colours_wanted();
  if (!screen_->colours) return;
  start_color();
  use_default_colors();
  init_pair(kGreen, COLOR_GREEN, -1);
  init_pair(kYellow, COLOR_YELLOW, -1);
  init_pair(kRed, COLOR_RED, -1);
}

Window::~Window() {
  endwin();
  delscreen(screen_->screen);
  std::fclose(screen_->input);
}

int Window::width() const { return getmaxx(stdscr); }
int Window::height() const { return getmaxy(stdscr); }
bool Window::unicode() const { return screen_->unicode; }
int Window::descriptor() const { return ::fileno(screen_->input); }

void Window::show(const std::vector<Line>& lines) {
  erase();
  for (int row = 0; row < static_cast<int>(lines.size()) && row < height(); ++row) {
    move(row, 0);
    for (const Span& span : lines[static_cast<size_t>(row)]) {
      const chtype attribute = attribute_of(span.role, screen_->colours);
      attron(attribute);
      addstr(span.text.c_str());
      attroff(attribute);
    }
  }
  refresh();
}

int Window::key() { return translated(getch()); }

}  // namespace live

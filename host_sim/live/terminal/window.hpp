// The screen of a terminal, by ncurses: lines in, keys out. Gives the terminal back as it was.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "host_sim/live/screen/text.hpp"

namespace live {

class Window {
 public:
  // Throws std::runtime_error where the terminal is none that ncurses knows.
  Window();
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  int width() const;
  int height() const;
  bool unicode() const;
  void show(const std::vector<Line>& lines);
  int key();               // kKeyNone: none was pressed
  int descriptor() const;  // to wait on

 private:
  struct Screen;
  std::unique_ptr<Screen> screen_;
};

}  // namespace live

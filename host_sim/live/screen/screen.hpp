// The picture as the lines of a screen. Pure: the same picture and view give the same lines.
#pragma once
#include <string>
#include <vector>

#include "host_sim/live/screen/text.hpp"
#include "host_sim/live/state/bus_picture.hpp"

namespace live {

struct View {
  int width = 80;
  int height = 0;  // 0: as many lines as there are
  bool unicode = true;
  int node = 1;        // whose estimates are shown
  int first_row = 0;   // of the table, where it does not fit
  std::string source;  // "can0", "run.log"
  bool ended = false;  // the log is over
  std::string prompt;  // last line: keys, or a question
  bool prompt_asks = false;
};

std::vector<Line> draw(const BusPicture& picture, const View& view);
// The largest first_row that still fills the table.
int last_first_row(const BusPicture& picture, const View& view);

}  // namespace live

// A watch from beginning to end: frames from the feed into the picture, the picture to a screen or, once, to text.
#pragma once
#include <cstdint>
#include <string>

#include "host_sim/live/state/bus_picture.hpp"
#include "host_sim/live/terminal/frame_feed.hpp"

namespace live {

struct SessionOptions {
  PictureOptions picture;
  std::string source;  // as shown in the title
  bool paced = false;  // a log: by its own times, `speed` times as fast
  double speed = 1.0;  // 0: as fast as it can be read
  int node = 0;        // 0: the first that is heard
};

struct SessionResult {
  uint64_t frames = 0;
  uint64_t skipped_lines = 0;
};

// Until q is pressed. Throws std::runtime_error where there is no terminal.
SessionResult watch_on_terminal(FrameFeed& feed, const SessionOptions& options);

// Everything up to the end of the feed (an interface: `seconds` long), then the table as text, without a terminal.
SessionResult watch_once(FrameFeed& feed, const SessionOptions& options, double seconds, int width, bool unicode,
                         std::string& text);

}  // namespace live

#include "host_sim/live/terminal/session.hpp"

#include <poll.h>

#include <algorithm>
#include <csignal>

#include "hal/linux/system/monotonic_clock.hpp"
#include "host_sim/live/screen/screen.hpp"
#include "host_sim/live/terminal/controls.hpp"
#include "host_sim/live/terminal/window.hpp"

namespace live {
namespace {

constexpr uint64_t kDrawPeriod_ns = 100000000, kWorkSpan_ns = 50000000;

volatile std::sig_atomic_t asked_to_end = 0;
void end_asked(int) { asked_to_end = 1; }

// While the screen is ours a signal ends the loop, so that the terminal is given back.
class EndSignals {
 public:
  EndSignals() {
    struct sigaction action {};
    action.sa_handler = end_asked;
    for (size_t i = 0; i < kCount; ++i) ::sigaction(kSignals[i], &action, &before_[i]);
  }
  ~EndSignals() {
    for (size_t i = 0; i < kCount; ++i) ::sigaction(kSignals[i], &before_[i], nullptr);
  }

 private:
  static constexpr int kSignals[] = {SIGTERM, SIGHUP, SIGINT};
  static constexpr size_t kCount = 3;
  struct sigaction before_[kCount] = {};
};

uint64_t wall_ns() { return hal::read_clock_ns(CLOCK_MONOTONIC); }

// The picture fed at the right pace. Time of the picture is that of the frames; between them it goes on with the clock.
class Course {
 public:
  Course(FrameFeed& feed, const SessionOptions& options) : feed_(feed), options_(options), picture_(options.picture) {}

  // Takes what is due; gives up for now after kWorkSpan_ns so that keys and screen are served.
  void run(uint64_t now_wall_ns) {
    const uint64_t until_ns = now_wall_ns + kWorkSpan_ns;
    for (int count = 1; !ended_; ++count) {
      if (!waiting_ && !fetch(now_wall_ns)) break;
      if (options_.paced && options_.speed > 0.0 && due_wall_ns() > now_wall_ns) break;
      offset_ns_ = entry_.frame.time_ns - now_wall_ns;
      picture_.take(entry_);
      ++frames_;
      waiting_ = false;
      if (count % 256 == 0 && wall_ns() > until_ns) return;
    }
    if (!ended_ && frames_ > 0) picture_.advance(picture_time(now_wall_ns));
  }

  BusPicture& picture() { return picture_; }
  bool ended() const { return ended_; }
  SessionResult result() const { return {frames_, feed_.skipped_lines()}; }
  // Until when nothing has to be done for the feed.
  uint64_t next_wall_ns(uint64_t now_wall_ns) const {
    if (waiting_ && options_.paced && options_.speed > 0.0) return std::max(now_wall_ns, due_wall_ns());
    return waiting_ ? now_wall_ns : now_wall_ns + kDrawPeriod_ns;
  }

 private:
  bool fetch(uint64_t now_wall_ns) {
    switch (feed_.next(entry_)) {
      case FeedResult::kFrame:
        break;
      case FeedResult::kEnded:
        ended_ = true;
        return false;
      case FeedResult::kDown:
        picture_.link_down(frames_ > 0 ? picture_time(now_wall_ns) : now_wall_ns);
        return false;
      case FeedResult::kNothing:
        return false;
    }
    if (!entry_.has_time) entry_.frame.time_ns = now_wall_ns;
    // A jump back, or the first frame: the pace starts here.
    if (!waiting_for_first_ && entry_.frame.time_ns >= last_log_ns_) {
      last_log_ns_ = entry_.frame.time_ns;
    } else {
      pace_log_ns_ = last_log_ns_ = entry_.frame.time_ns;
      pace_wall_ns_ = now_wall_ns;
      waiting_for_first_ = false;
    }
    waiting_ = true;
    return true;
  }

  uint64_t due_wall_ns() const {
    return pace_wall_ns_ +
           static_cast<uint64_t>(static_cast<double>(entry_.frame.time_ns - pace_log_ns_) / options_.speed);
  }
  uint64_t picture_time(uint64_t now_wall_ns) const {
    if (!options_.paced) return now_wall_ns + offset_ns_;  // modulo 2^64: the offset may be negative
    return pace_log_ns_ + static_cast<uint64_t>(static_cast<double>(now_wall_ns - pace_wall_ns_) * options_.speed);
  }

  FrameFeed& feed_;
  SessionOptions options_;
  BusPicture picture_;
  can_log::LogEntry entry_;
  bool waiting_ = false, ended_ = false, waiting_for_first_ = true;
  uint64_t pace_log_ns_ = 0, pace_wall_ns_ = 0, last_log_ns_ = 0, offset_ns_ = 0, frames_ = 0;
};

View view_of(const BusPicture& picture, const Controls& controls, const SessionOptions& options, bool ended) {
  View view;
  view.node = options.node > 0 ? options.node : controls.node();
  view.first_row = controls.first_row();
  view.source = options.source;
  view.ended = ended;
  view.prompt = controls.prompt();
  view.prompt_asks = controls.asks();
  (void)picture;
  return view;
}

void show(Window& window, Course& course, Controls& controls, const SessionOptions& options) {
  View view = view_of(course.picture(), controls, options, course.ended());
  view.width = window.width();
  view.height = window.height();
  view.unicode = window.unicode();
  controls.limit_rows(last_first_row(course.picture(), view));
  window.show(draw(course.picture(), view));
}

void press(int key, FrameFeed& feed, Course& course, Controls& controls) {
  const std::optional<firmware::CanFrame> message = controls.press(key, course.picture().nodes());
  if (!message) return;
  const bool sent = feed.send(*message);
  firmware::NetworkCommand command;
  const bool network = firmware::unpack_network_command(*message, command);
  const std::string what = network ? "command" : "SYNC (window now)";
  controls.tell(sent ? what + " sent" : what + " NOT sent: the bus takes no frames");
}

void wait(const FrameFeed& feed, const Window& window, bool paced, uint64_t until_ns) {
  const uint64_t now_ns = wall_ns();
  const int timeout_ms = until_ns > now_ns ? static_cast<int>((until_ns - now_ns) / 1000000 + 1) : 0;
  pollfd ready[] = {{window.descriptor(), POLLIN, 0}, {paced ? -1 : feed.descriptor(), POLLIN, 0}};
  ::poll(ready, 2, std::min(timeout_ms, 1000));
}

}  // namespace

SessionResult watch_on_terminal(FrameFeed& feed, const SessionOptions& options) {
  Window window;
  const EndSignals signals;
  Course course(feed, options);
  Controls controls(feed.can_send());
  uint64_t next_draw_ns = 0;
  while (!controls.quit() && asked_to_end == 0) {
    const uint64_t now_ns = wall_ns();
    course.run(now_ns);
    controls.follow(course.picture().nodes());
    bool pressed = false;
    for (int key = window.key(); key != kKeyNone; key = window.key()) {
      press(key, feed, course, controls);
      pressed = true;
    }
    if (pressed || now_ns >= next_draw_ns) {
      show(window, course, controls, options);
      next_draw_ns = now_ns + kDrawPeriod_ns;
    }
    const uint64_t due_ns = course.ended() ? next_draw_ns : std::min(next_draw_ns, course.next_wall_ns(now_ns));
    wait(feed, window, options.paced || course.ended(), due_ns);
  }
  return course.result();
}

SessionResult watch_once(FrameFeed& feed, const SessionOptions& options, double seconds, int width, bool unicode,
                         std::string& text) {
  SessionOptions at_once = options;
  at_once.speed = 0.0;
  Course course(feed, at_once);
  const uint64_t end_ns = wall_ns() + static_cast<uint64_t>(seconds * 1e9);
  for (uint64_t now_ns = wall_ns(); !course.ended() && (!feed.can_send() || now_ns < end_ns); now_ns = wall_ns()) {
    course.run(now_ns);
    pollfd ready{feed.descriptor(), POLLIN, 0};
    if (!course.ended()) ::poll(&ready, 1, feed.can_send() ? 100 : 1000);
  }
  Controls controls(false);
  controls.follow(course.picture().nodes());
  View view = view_of(course.picture(), controls, options, course.ended());
  view.width = width;
  view.unicode = unicode;
  view.prompt.clear();
  for (const Line& line : draw(course.picture(), view)) text += plain_text(line) + "\n";
  return course.result();
}

}  // namespace live

#include "host_sim/live/terminal/frame_feed.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>

#include "host_sim/can_log/asc_line.hpp"

namespace live {
namespace {

constexpr size_t kReadBytes = 65536, kLongestLine = 4096;

class TextFeed final : public FrameFeed {
 public:
  explicit TextFeed(hal::FileDescriptor file) : file_(std::move(file)) {}

  FeedResult next(can_log::LogEntry& entry) override {
    std::string line;
    for (;;) {
      while (take_line(line)) {
        if (can_log::parse_line(line, entry) || asc_.parse(line, entry)) return FeedResult::kFrame;
        if (line.find_first_not_of(" \t\r") != std::string::npos) ++skipped_;
      }
      if (ended_) return FeedResult::kEnded;
      if (!read_more()) return FeedResult::kNothing;
    }
  }

  int descriptor() const override { return ended_ ? -1 : file_.get(); }
  uint64_t skipped_lines() const override { return skipped_; }

 private:
  // A line at the end of the file needs no newline; one that is longer than any frame is given up.
  bool take_line(std::string& line) {
    const size_t end = text_.find('\n', begin_);
    if (end == std::string::npos) {
      text_.erase(0, begin_);
      begin_ = 0;
      if (text_.size() > kLongestLine) text_.assign("?");
      if (!ended_ || text_.empty()) return false;
      line.swap(text_);
      text_.clear();
      return true;
    }
    line.assign(text_, begin_, end - begin_);
    begin_ = end + 1;
    return true;
  }

  // False where nothing is there yet.
  bool read_more() {
    pollfd ready{file_.get(), POLLIN, 0};
    if (::poll(&ready, 1, 0) <= 0) return false;
    char bytes[kReadBytes];
    const ssize_t count = ::read(file_.get(), bytes, sizeof bytes);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return false;
    if (count <= 0) {
      ended_ = true;
    } else {
      text_.append(bytes, static_cast<size_t>(count));
    }
    return true;
  }

  hal::FileDescriptor file_;
  std::string text_;
  can_log::AscLog asc_;
  size_t begin_ = 0;
  bool ended_ = false;
  uint64_t skipped_ = 0;
};

class InterfaceFeed final : public FrameFeed {
 public:
  explicit InterfaceFeed(const std::string& interface) : interface_(interface) {
    hal::SocketCan::Options options;
    options.fd = true;
    if (bus_.open(interface, options).empty()) return;
    options.fd = false;  // an interface for classic CAN alone
    const std::string fault = bus_.open(interface, options);
    if (!fault.empty()) throw std::runtime_error(fault);
  }

  FeedResult next(can_log::LogEntry& entry) override {
    entry = can_log::LogEntry();
    entry.has_time = true;
    entry.interface = interface_;
    switch (bus_.receive(entry.frame)) {
      case hal::CanResult::kDone:
        return FeedResult::kFrame;
      case hal::CanResult::kBusDown:
        return FeedResult::kDown;
      default:
        return FeedResult::kNothing;
    }
  }

  int descriptor() const override { return bus_.descriptor(); }
  bool can_send() const override { return true; }
  bool send(const firmware::CanFrame& message) override {
    return bus_.send(can_log::to_frame(message, 0)) == hal::CanResult::kDone;
  }

 private:
  hal::SocketCan bus_;
  std::string interface_;
};

}  // namespace

std::unique_ptr<FrameFeed> text_feed(hal::FileDescriptor file) { return std::make_unique<TextFeed>(std::move(file)); }

std::unique_ptr<FrameFeed> interface_feed(const std::string& interface) {
  return std::make_unique<InterfaceFeed>(interface);
}

}  // namespace live

// Frames out of a text, whichever program wrote it.
#include "host_sim/live/terminal/frame_feed.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <string>

namespace live {
namespace {

// Times and first bytes of the frames in a text, and how many lines were none.
std::string read(const std::string& text) {
  int ends[2] = {-1, -1};
  EXPECT_EQ(::pipe(ends), 0);
  EXPECT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  ::close(ends[1]);
  const auto feed = text_feed(hal::FileDescriptor(ends[0]));
  can_log::LogEntry entry;
  std::string said;
  for (FeedResult result = feed->next(entry); result != FeedResult::kEnded; result = feed->next(entry))
    if (result == FeedResult::kFrame)
      said += std::to_string(entry.frame.time_ns / 1000) + " us " + std::to_string(entry.frame.data[0]) + ", ";
  return said + std::to_string(feed->skipped_lines()) + " skipped";
}

TEST(FrameFeed, CandumpText) {
  EXPECT_EQ(read("(0.001250) can0 123#1122\nnothing\n\n(0.002250) can0 123#33"), "1250 us 17, 2250 us 51, 1 skipped");
}

// Relative times add up: 1.25 ms, then 1 ms more. The three lines of its head and its end are no frames.
TEST(FrameFeed, VectorsLog) {
  EXPECT_EQ(read("date Sun Nov 22 07:00:00.000 am 2026\nbase hex  timestamps relative\nBegin Triggerblock\n"
                 "   0.001250 1  123             Rx   d 2 11 22\n   0.001000 1  123             Rx   d 1 33\n"
                 "End TriggerBlock\n"),
            "1250 us 17, 2250 us 51, 4 skipped");
}

}  // namespace
}  // namespace live

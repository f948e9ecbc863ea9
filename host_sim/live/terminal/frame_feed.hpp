// Where the frames come from: candump text or a Vector .asc log from a pipe or a file, or a CAN interface. Never blocks.
#pragma once
#include <memory>
#include <string>

#include "firmware/can_protocol/can_frame.hpp"
#include "hal/linux/can/socket_can.hpp"
#include "hal/linux/system/file_descriptor.hpp"
#include "host_sim/can_log/candump_line.hpp"

namespace live {

enum class FeedResult { kFrame, kNothing, kDown, kEnded };

class FrameFeed {
 public:
  virtual ~FrameFeed() = default;
  virtual FeedResult next(can_log::LogEntry& entry) = 0;
  virtual int descriptor() const = 0;  // to wait on; -1: none
  virtual bool can_send() const { return false; }
  virtual bool send(const firmware::CanFrame&) { return false; }
  virtual uint64_t skipped_lines() const { return 0; }
};

// What candump prints, or Vector's tools write as .asc, from a descriptor that this takes over. Lines that are no frames are counted.
std::unique_ptr<FrameFeed> text_feed(hal::FileDescriptor file);
// Throws host_sim-independent std::runtime_error with what is wrong and what to do about it.
std::unique_ptr<FrameFeed> interface_feed(const std::string& interface);

}  // namespace live

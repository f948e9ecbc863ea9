// A file that grows, as a stream that never ends: at its end it waits for more, and it starts again where the file has
// become shorter. Whole lines alone are handed on: who reads lines never waits within one.
#pragma once
#include <streambuf>
#include <string>

#include "hal/linux/system/file_descriptor.hpp"

namespace can_log {

class FollowBuffer : public std::streambuf {
 public:
  explicit FollowBuffer(const std::string& path);
  bool is_open() const { return static_cast<bool>(file_); }

 protected:
  int_type underflow() override;

 private:
  hal::FileDescriptor file_;
  std::string lines_;    // handed on
  std::string pending_;  // the beginning of a line
};

}  // namespace can_log

// A file that grows, as a stream that never ends: at its end it waits for more, and it starts again where the file has
// become shorter.
#pragma once
#include <streambuf>
#include <string>
#include <vector>

#include "hal/linux/file_descriptor.hpp"

namespace can_log {

class FollowBuffer : public std::streambuf {
 public:
  explicit FollowBuffer(const std::string& path);
  bool is_open() const { return static_cast<bool>(file_); }

 protected:
  int_type underflow() override;

 private:
  hal::FileDescriptor file_;
  std::vector<char> bytes_;
};

}  // namespace can_log

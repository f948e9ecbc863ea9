#include "host_sim/can_log/follow_buffer.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace can_log {
namespace {

constexpr size_t kBufferBytes = 65536;
constexpr int kWait_ms = 100;

// A log that was begun anew is read from its start.
void rewind_if_shorter(int file) {
  struct stat status {};
  const off_t place = ::lseek(file, 0, SEEK_CUR);
  if (place > 0 && ::fstat(file, &status) == 0 && status.st_size < place) ::lseek(file, 0, SEEK_SET);
}

}  // namespace

FollowBuffer::FollowBuffer(const std::string& path) : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}

std::streambuf::int_type FollowBuffer::underflow() {
  char bytes[kBufferBytes];
  for (;;) {
    const ssize_t count = ::read(file_.get(), bytes, sizeof bytes);
    if (count < 0 && errno != EINTR) return traits_type::eof();
    if (count > 0) {
      pending_.append(bytes, static_cast<size_t>(count));
      const size_t end = pending_.size() > kBufferBytes ? pending_.size() - 1 : pending_.rfind('\n');
      if (end == std::string::npos) continue;
      lines_ = pending_.substr(0, end + 1);
      pending_.erase(0, end + 1);
      setg(lines_.data(), lines_.data(), lines_.data() + lines_.size());
      return traits_type::to_int_type(*gptr());
    }
    rewind_if_shorter(file_.get());
    ::poll(nullptr, 0, kWait_ms);
  }
}

}  // namespace can_log

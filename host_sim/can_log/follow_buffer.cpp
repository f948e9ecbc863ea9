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

FollowBuffer::FollowBuffer(const std::string& path)
    : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), bytes_(kBufferBytes) {}

std::streambuf::int_type FollowBuffer::underflow() {
  for (;;) {
    const ssize_t count = ::read(file_.get(), bytes_.data(), bytes_.size());
    if (count > 0) {
      setg(bytes_.data(), bytes_.data(), bytes_.data() + count);
      return traits_type::to_int_type(*gptr());
    }
    if (count < 0 && errno != EINTR) return traits_type::eof();
    rewind_if_shorter(file_.get());
    ::poll(nullptr, 0, kWait_ms);
  }
}

}  // namespace can_log

#include "hal/linux/store/posix_file_operations.hpp"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>

#include <cstring>

namespace hal {
namespace {

// Reads until size bytes are there or the file ends. Negative: an error.
ssize_t read_fully(int file, uint8_t* bytes, size_t size) {
  size_t done = 0;
  while (done < size) {
    const ssize_t count = ::read(file, bytes + done, size - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return -1;
    if (count == 0) break;
    done += static_cast<size_t>(count);
  }
  return static_cast<ssize_t>(done);
}

}  // namespace

std::string PosixFileOperations::open(const std::string& folder) {
  if (::mkdir(folder.c_str(), 0750) != 0 && errno != EEXIST)
    return "folder " + folder + " cannot be made: " + std::strerror(errno);
  folder_ = FileDescriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return folder_ ? "" : "folder " + folder + " cannot be opened: " + std::strerror(errno);
}

bool PosixFileOperations::create(const char* name) {
  file_ = FileDescriptor(::openat(folder_.get(), name, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0640));
  return static_cast<bool>(file_);
}

bool PosixFileOperations::write(const uint8_t* bytes, size_t size) {
  while (size > 0) {
    const ssize_t count = ::write(file_.get(), bytes, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    size -= static_cast<size_t>(count);
  }
  return true;
}

bool PosixFileOperations::sync_file() { return ::fsync(file_.get()) == 0; }

bool PosixFileOperations::close() {
  file_.reset();
  return true;
}

bool PosixFileOperations::rename(const char* from, const char* to) {
  return ::renameat(folder_.get(), from, folder_.get(), to) == 0;
}

bool PosixFileOperations::sync_folder() { return ::fsync(folder_.get()) == 0; }

size_t PosixFileOperations::read(const char* name, uint8_t* bytes, size_t capacity) {
  const FileDescriptor file(::openat(folder_.get(), name, O_RDONLY | O_CLOEXEC));
  struct stat about {};
  if (!file || ::fstat(file.get(), &about) != 0) return 0;
  if (about.st_size < 0 || static_cast<uint64_t>(about.st_size) > capacity) return 0;
  const ssize_t count = read_fully(file.get(), bytes, capacity);
  return count < 0 ? 0 : static_cast<size_t>(count);
}

}  // namespace hal

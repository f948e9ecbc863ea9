#include "hal/linux/system/sysfs.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "hal/linux/system/file_descriptor.hpp"

namespace hal {

std::string read_text(const std::string& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) return "";
  char text[4096];
  const ssize_t size = ::read(file.get(), text, sizeof text);
  std::string result(text, size > 0 ? static_cast<size_t>(size) : 0);
  while (!result.empty() && (result.back() == '\n' || result.back() == '\0')) result.pop_back();
  return result;
}

bool write_text(const std::string& path, const std::string& text) {
  const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  return file && ::write(file.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

bool file_exists(const std::string& path) { return ::access(path.c_str(), F_OK) == 0; }

}  // namespace hal

#include "hal/linux/iio/iio_drive_output.hpp"

#include <errno.h>
#include <fcntl.h>

#include <charconv>
#include <cstring>

namespace hal {

std::string IioDriveOutput::open(const Options& options, const IioRoots& roots) {
  const std::string id = find_iio_device(roots, options.device);
  if (id.empty()) return not_found(roots, options.device);
  const std::string path = roots.devices + "/" + id + "/" + options.element + "_raw";
  file_ = FileDescriptor(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  zero_code_ = options.zero_code;
  full_scale_code_ = options.full_scale_code;
  return file_ ? "" : path + ": " + std::strerror(errno) + ", expected an output of " + options.device;
}

bool IioDriveOutput::write(int32_t drive_q31) {
  // Rounded to the nearest code; a half goes up.
  const int64_t swing = (static_cast<int64_t>(drive_q31) * full_scale_code_ + (int64_t{1} << 30)) >> 31;
  char text[16];
  const auto end = std::to_chars(text, text + sizeof text, zero_code_ + swing).ptr;
  const auto size = end - text;
  return file_ && ::pwrite(file_.get(), text, static_cast<size_t>(size), 0) == size;
}

}  // namespace hal

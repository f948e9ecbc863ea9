#include "hal/linux/iio/iio_channel.hpp"

#include <dirent.h>

#include <algorithm>

#include "hal/linux/system/sysfs.hpp"

namespace hal {
namespace {

constexpr int kCodeBits = 24;

}  // namespace

std::string find_iio_device(const IioRoots& roots, const std::string& name) {
  DIR* folder = opendir(roots.devices.c_str());
  std::string found;
  while (const dirent* entry = folder == nullptr ? nullptr : readdir(folder)) {
    const std::string candidate = entry->d_name;
    if (candidate[0] == '.') continue;
    if (candidate == name || read_text(roots.devices + "/" + candidate + "/name") == name) found = candidate;
  }
  if (folder != nullptr) closedir(folder);
  return found;
}

int32_t code_of(int64_t value, const ScanType& type) {
  const CodeRange range = code_range(type);
  const int64_t code = type.bits > kCodeBits ? value >> (type.bits - kCodeBits) : value;
  return static_cast<int32_t>(std::clamp<int64_t>(code, range.lowest, range.highest));
}

CodeRange code_range(const ScanType& type) {
  const int bits = std::min<int>(type.bits, kCodeBits);
  if (!type.is_signed) return {0, (1 << bits) - 1};
  return {-(1 << (bits - 1)), (1 << (bits - 1)) - 1};
}

}  // namespace hal

#include "hal/linux/iio_channel.hpp"

#include <dirent.h>

#include "hal/linux/sysfs.hpp"

namespace hal {

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

int32_t code_of(int64_t value, int bits) { return static_cast<int32_t>(bits > 24 ? value >> (bits - 24) : value); }

}  // namespace hal

#include "hal/linux/iio/iio_channel.hpp"

#include <dirent.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "hal/linux/system/sysfs.hpp"

namespace hal {
namespace {

constexpr int kCodeBits = 24;
constexpr double kSameRate = 1e-4;

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

std::string not_found(const IioRoots& roots, const std::string& name) {
  return "IIO device \"" + name + "\" was not found, expected a name from " + roots.devices + "/*/name";
}

std::string rate_text(double rate_Hz) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6f", rate_Hz);
  std::string rate = text;
  rate.erase(rate.find_last_not_of('0') + 1);
  if (rate.back() == '.') rate.pop_back();
  return rate;
}

bool is_rate(const std::string& told, double rate_Hz) {
  char* end = nullptr;
  const double value = std::strtod(told.c_str(), &end);
  return end == told.c_str() || std::abs(value / rate_Hz - 1.0) <= kSameRate;
}

int32_t code_of(int64_t value, const ScanType& type) {
  const CodeRange range = code_range(type);
  // Half of what is dropped is added behind the shift of all other bits: no value overflows.
  const int64_t code = range.dropped_bits > 0 ? ((value >> (range.dropped_bits - 1)) + 1) >> 1 : value;
  return static_cast<int32_t>(std::clamp<int64_t>(code, range.lowest, range.highest));
}

CodeRange code_range(const ScanType& type) {
  const int bits = std::min<int>(type.bits, kCodeBits), dropped = type.bits - bits;
  if (!type.is_signed) return {0, (1 << bits) - 1, dropped};
  return {-(1 << (bits - 1)), (1 << (bits - 1)) - 1, dropped};
}

}  // namespace hal

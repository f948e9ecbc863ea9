#include "hal/linux/iio/iio_direct_source.hpp"

#include <errno.h>
#include <fcntl.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "hal/linux/system/sysfs.hpp"

namespace hal {

std::string IioDirectSource::open(const Options& options, const std::vector<IioChannel>& channels,
                                  const IioRoots& roots) {
  const std::string id = find_iio_device(roots, options.device);
  if (id.empty()) return not_found(roots, options.device);
  period_ns_ = static_cast<uint64_t>(std::llround(1e9 / options.sample_rate_Hz));
  for (const IioChannel& channel : channels) {
    const std::string path = roots.devices + "/" + id + "/" + channel.element + "_raw";
    Place& place = places_[place_count_++];
    place.file = FileDescriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!place.file) return path + ": " + std::strerror(errno) + ", expected an input of " + options.device;
    place.node = channel.node;
    place.quantity = static_cast<uint8_t>(channel.quantity);
    parse_scan_type(read_text(roots.devices + "/" + id + "/scan_elements/" + channel.element + "_type"), place.type);
  }
  return "";
}

std::optional<CodeRange> IioDirectSource::range(int node, firmware::Quantity quantity) const {
  for (int i = 0; i < place_count_; ++i)
    if (places_[i].node == node && places_[i].quantity == static_cast<uint8_t>(quantity) && places_[i].type.bits > 0)
      return code_range(places_[i].type);
  return std::nullopt;
}

SampleResult IioDirectSource::read(firmware::RawSample& sample) {
  const uint64_t now_ns = clock_.now_ns();
  if (!started_) start_ns_ = now_ns;
  started_ = true;
  const uint64_t due = (now_ns - start_ns_) / period_ns_;
  if (due < next_) return SampleResult::kNone;
  next_ = due + 1;
  sample = firmware::RawSample();
  sample.sequence = static_cast<uint32_t>(due);
  sample.time_ns = now_ns;
  for (int i = 0; i < place_count_; ++i) {
    char text[32];
    const ssize_t size = ::pread(places_[i].file.get(), text, sizeof text, 0);
    int64_t value = 0;
    if (size <= 0 || std::from_chars(text, text + size, value).ec != std::errc()) return SampleResult::kFault;
    const Place& place = places_[i];
    sample.code[place.node][place.quantity] =
        place.type.bits > 0 ? code_of(value, place.type)
                            : static_cast<int32_t>(std::clamp<int64_t>(value, INT32_MIN, INT32_MAX));
  }
  return SampleResult::kSample;
}

}  // namespace hal

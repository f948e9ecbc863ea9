#include "hal/linux/iio/iio_buffer_source.hpp"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "hal/linux/system/monotonic_clock.hpp"
#include "hal/linux/system/sysfs.hpp"

namespace hal {
namespace {

struct Element {
  std::string name;
  int index = 0;
};

// The elements that a device can scan, by rising index.
std::vector<Element> elements_of(const std::string& scan_folder) {
  std::vector<Element> elements;
  DIR* folder = opendir(scan_folder.c_str());
  while (const dirent* entry = folder == nullptr ? nullptr : readdir(folder)) {
    std::string name = entry->d_name;
    if (name.size() < 4 || name.compare(name.size() - 3, 3, "_en") != 0) continue;
    name.resize(name.size() - 3);
    const std::string index = read_text(scan_folder + "/" + name + "_index");
    if (!index.empty()) elements.push_back({name, std::atoi(index.c_str())});
  }
  if (folder != nullptr) closedir(folder);
  std::sort(elements.begin(), elements.end(), [](const Element& a, const Element& b) { return a.index < b.index; });
  return elements;
}

std::string list(const std::vector<Element>& elements) {
  std::string text;
  for (const Element& element : elements) text += (text.empty() ? "" : ", ") + element.name;
  return text;
}

}  // namespace

IioBufferSource::~IioBufferSource() {
  device_.reset();
  if (!enable_path_.empty()) write_text(enable_path_, "0");
}

std::string IioBufferSource::open(const Options& options, const std::vector<IioChannel>& channels,
                                  const IioRoots& roots) {
  const std::string id = find_iio_device(roots, options.device);
  if (id.empty()) return not_found(roots, options.device);
  const std::string folder = roots.devices + "/" + id;
  if (!file_exists(folder + "/buffer/enable"))
    return "IIO device \"" + options.device + "\" has no buffer, expected source kind \"iio_direct\" for it";
  write_text(folder + "/buffer/enable", "0");
  const std::string fault = lay_out(folder, channels);
  if (!fault.empty()) return "IIO device \"" + options.device + "\": " + fault;
  device_ = FileDescriptor(::open((roots.character_devices + "/" + id).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (!device_) return "IIO device " + roots.character_devices + "/" + id + ": " + std::strerror(errno);
  return start(options, folder, roots);
}

// Switches the wanted elements on and all others off, these first: a driver that can scan few elements together refuses the new
// ones beside the old. Works out where they lie in a scan.
std::string IioBufferSource::lay_out(const std::string& folder, const std::vector<IioChannel>& channels) {
  const std::string scan_folder = folder + "/scan_elements";
  const std::vector<Element> elements = elements_of(scan_folder);
  const auto uses_of = [&](const Element& element) {
    return std::count_if(channels.begin(), channels.end(),
                         [&](const IioChannel& channel) { return channel.element == element.name; });
  };
  for (const Element& element : elements)
    if (uses_of(element) == 0) write_text(scan_folder + "/" + element.name + "_en", "0");
  ScanLayout layout;
  for (const Element& element : elements) {
    const bool is_time = element.name == "in_timestamp";
    const bool used = uses_of(element) > 0;
    if (!used && !is_time) continue;
    const bool enabled = write_text(scan_folder + "/" + element.name + "_en", "1");
    if (!used && !enabled) continue;
    if (!enabled) return element.name + " cannot be switched on";
    Place place;
    const std::string type = read_text(scan_folder + "/" + element.name + "_type");
    if (!parse_scan_type(type, place.type)) return element.name + "_type is \"" + type + "\", which is no scan type";
    place.offset = layout.add(place.type);
    if (place.offset < 0) return "more than " + std::to_string(kMaxScanElements) + " elements are to be scanned";
    if (is_time) {
      time_ = place;
      stamped_ = true;
    }
    for (const IioChannel& channel : channels) {
      if (channel.element != element.name) continue;
      place.node = channel.node;
      place.quantity = static_cast<uint8_t>(channel.quantity);
      places_[place_count_++] = place;
    }
  }
  for (const IioChannel& channel : channels) {
    const auto same = [&](const Element& element) { return element.name == channel.element; };
    if (std::none_of(elements.begin(), elements.end(), same))
      return "there is no element \"" + channel.element + "\", expected one of: " + list(elements);
  }
  scan_bytes_ = layout.size();
  return scan_bytes_ > kMaxScanBytes ? "a scan is longer than " + std::to_string(kMaxScanBytes) + " bytes" : "";
}

// folder: of the device or of its trigger, whichever has a rate to set.
std::string IioBufferSource::set_rate(const Options& options, const std::string& folder) {
  const std::string path = folder + "/sampling_frequency";
  if (!file_exists(path)) return "";
  const std::string wanted = rate_text(options.sample_rate_Hz);
  if (!write_text(path, wanted))
    return "sampling frequency " + wanted + " Hz is not taken by " + path +
           ", expected one of: " + read_text(folder + "/sampling_frequency_available");
  const std::string taken = read_text(path);
  return is_rate(taken, options.sample_rate_Hz) ? ""
                                                : "sampling frequency " + wanted + " Hz became " + taken + " Hz in " +
                                                      path + ", expected a rate_Hz that it has";
}

std::string IioBufferSource::start(const Options& options, const std::string& folder, const IioRoots& roots) {
  if (!options.trigger.empty() && !write_text(folder + "/trigger/current_trigger", options.trigger))
    return "IIO trigger \"" + options.trigger +
           "\" is not taken, expected a name from /sys/bus/iio/devices/trigger*/name";
  if (options.sample_rate_Hz > 0.0) {
    period_ns_ = 1e9 / options.sample_rate_Hz;
    std::string fault = set_rate(options, folder);
    const std::string trigger = options.trigger.empty() ? "" : find_iio_device(roots, options.trigger);
    if (fault.empty() && !trigger.empty()) fault = set_rate(options, roots.devices + "/" + trigger);
    if (!fault.empty()) return fault;
  }
  const std::string clock = folder + "/current_timestamp_clock";
  time_of_day_ = !write_text(clock, "monotonic") || read_text(clock) != "monotonic";
  buffer_ns_ = period_ns_ * static_cast<double>(options.buffer_scans);
  write_text(folder + "/buffer/length", std::to_string(options.buffer_scans));
  enable_path_ = folder + "/buffer/enable";
  return write_text(enable_path_, "1") ? ""
                                       : "the buffer of \"" + options.device + "\" does not start: is its trigger set?";
}

// Periods since the last sample. They are counted against a grid, not from stamp to stamp: a stamp that an interrupt made late
// would else stand for a missed sample. A stamp comes late, hardly ever early: one that is early moves the grid at once, late
// ones move it slowly, so that it follows a clock that is slow.
uint32_t IioBufferSource::periods_until(uint64_t time_ns) {
  constexpr double kEarly = 0.25;       // of a period: what a stamp behind a missed sample may be early
  constexpr double kFollowed = 0.0625;  // of what a stamp is late: 1000 ppm make 0.016 of a period
  const double since_grid_ns = late_ns_ + static_cast<double>(static_cast<int64_t>(time_ns - last_ns_));
  const double steps = std::max(1.0, std::floor(since_grid_ns / period_ns_ + kEarly));
  late_ns_ = std::max(0.0, since_grid_ns - steps * period_ns_) * (1.0 - kFollowed);
  return static_cast<uint32_t>(std::min(steps, static_cast<double>(INT32_MAX)));
}

// Sequence and time of a sample.
void IioBufferSource::count_on(uint64_t time_ns, firmware::RawSample& sample) {
  const uint32_t steps = stamped_ && started_ && period_ns_ > 0.0 ? periods_until(time_ns) : 1;
  if (stamped_ && period_ns_ > 0.0) count_overflow(steps, time_ns);
  sequence_ = started_ ? sequence_ + steps : 0;
  started_ = true;
  last_ns_ = time_ns;
  sample.sequence = sequence_;
  sample.time_ns = time_ns;
}

void IioBufferSource::count_overflow(uint32_t steps, uint64_t time_ns) {
  if (steps > 1 && last_ns_ <= full_until_ns_) overflows_ += steps - 1;
  const uint64_t now_ns = clock_.now_ns();
  const uint64_t lay_ns = now_ns > time_ns ? now_ns - time_ns : 0;
  if (static_cast<double>(lay_ns) >= buffer_ns_) full_until_ns_ = time_ns + static_cast<uint64_t>(buffer_ns_);
}

uint64_t IioBufferSource::stamp_of_scan() const {
  if (!stamped_) return clock_.now_ns();
  const auto stamp = static_cast<uint64_t>(decode_element(time_.type, scan_ + time_.offset));
  return time_of_day_ ? monotonic_from_time_of_day_ns(stamp) : stamp;
}

CodeRange IioBufferSource::range(int node, firmware::Quantity quantity) const {
  for (int i = 0; i < place_count_; ++i)
    if (places_[i].node == node && places_[i].quantity == static_cast<uint8_t>(quantity))
      return code_range(places_[i].type);
  return {};
}

SampleResult IioBufferSource::read(firmware::RawSample& sample) {
  while (filled_ < scan_bytes_) {
    const ssize_t count = ::read(device_.get(), scan_ + filled_, scan_bytes_ - filled_);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno == EAGAIN ? SampleResult::kNone : SampleResult::kFault;
    if (count == 0) return SampleResult::kEnd;  // the device was removed
    filled_ += static_cast<size_t>(count);
  }
  filled_ = 0;
  sample = firmware::RawSample();
  for (int i = 0; i < place_count_; ++i) {
    const Place& place = places_[i];
    sample.code[place.node][place.quantity] = code_of(decode_element(place.type, scan_ + place.offset), place.type);
  }
  count_on(stamp_of_scan(), sample);
  return SampleResult::kSample;
}

}  // namespace hal

// Samples from the buffer of an IIO device: the driver collects whole scans on its trigger, the character device hands
// them over. The trigger is the sample clock; where the driver stamps its scans, a gap in the stamps is a missed
// sample; a stamp that is late by up to three quarters of a period is not. A driver drops what comes while its buffer is full and says nothing: a gap behind a scan that lay for as long
// as the buffer holds is put down to that.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "hal/interface/clock.hpp"
#include "hal/interface/sample_source.hpp"
#include "hal/linux/iio/iio_channel.hpp"
#include "hal/linux/iio/iio_scan_format.hpp"
#include "hal/linux/system/file_descriptor.hpp"

namespace hal {

class IioBufferSource final : public SampleSource {
 public:
  struct Options {
    std::string device;           // name or iio:deviceN
    std::string trigger;          // name of the trigger; empty: the driver's own
    double sample_rate_Hz = 0.0;  // also written to sampling_frequency where device or trigger has one
    size_t buffer_scans = 256;
  };

  explicit IioBufferSource(MonotonicClock& clock) : clock_(clock) {}
  // Enables the elements, sets the layout, starts the buffer. Empty where it worked, else what is wrong.
  std::string open(const Options& options, const std::vector<IioChannel>& channels, const IioRoots& roots = {});
  ~IioBufferSource();

  SampleResult read(firmware::RawSample& sample) override;
  uint32_t overflows() const override { return overflows_; }
  CodeRange range(int node, firmware::Quantity quantity) const;  // of a channel, by the driver's word width
  int descriptor() const { return device_.get(); }
  size_t scan_bytes() const { return scan_bytes_; }

 private:
  static constexpr size_t kMaxScanBytes = 1024;
  struct Place {
    ScanType type;
    int offset = 0;
    uint8_t node = 0;
    uint8_t quantity = 0;
  };
  std::string lay_out(const std::string& folder, const std::vector<IioChannel>& channels);
  std::string set_rate(const Options& options, const std::string& folder);
  std::string start(const Options& options, const std::string& folder, const IioRoots& roots);
  uint32_t periods_until(uint64_t time_ns);
  void count_on(uint64_t time_ns, firmware::RawSample& sample);
  void count_overflow(uint32_t steps, uint64_t time_ns);
  uint64_t stamp_of_scan() const;

  MonotonicClock& clock_;
  std::string enable_path_;
  FileDescriptor device_;
  Place places_[firmware::kMaxNodes * firmware::kQuantities];
  int place_count_ = 0;
  Place time_;
  bool stamped_ = false;
  bool time_of_day_ = false;  // the driver's stamps are not on the monotonic clock
  size_t scan_bytes_ = 0;
  uint8_t scan_[kMaxScanBytes] = {};
  size_t filled_ = 0;  // bytes of the scan that are there
  double period_ns_ = 0.0;
  bool started_ = false;
  uint32_t sequence_ = 0;
  uint64_t last_ns_ = 0;
  double late_ns_ = 0.0;        // the last stamp, against the grid
  double buffer_ns_ = 0.0;      // what the buffer holds
  uint64_t full_until_ns_ = 0;  // stamp of the last scan that a buffer which was full had room for
  uint32_t overflows_ = 0;
};

}  // namespace hal

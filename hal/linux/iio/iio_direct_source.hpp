// Samples from an IIO driver without a buffer: one read of in_voltageN_raw for each channel, at the times of a clock
// that does not drift. Channels are read one after the other, so they are late against each other by one conversion
// each.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "hal/interface/clock.hpp"
#include "hal/interface/sample_source.hpp"
#include "hal/linux/iio/iio_channel.hpp"
#include "hal/linux/system/file_descriptor.hpp"

namespace hal {

class IioDirectSource final : public SampleSource {
 public:
  struct Options {
    std::string device;  // name or iio:deviceN
    double sample_rate_Hz = 1000.0;
  };

  explicit IioDirectSource(MonotonicClock& clock) : clock_(clock) {}
  std::string open(const Options& options, const std::vector<IioChannel>& channels, const IioRoots& roots = {});

  // A sample is due at every whole period after the first call; a call that comes later than the next one leaves a gap
  // in the sequence.
  SampleResult read(firmware::RawSample& sample) override;
  // Of a channel, where the driver tells its word width.
  std::optional<CodeRange> range(int node, firmware::Quantity quantity) const;

 private:
  struct Place {
    FileDescriptor file;
    uint8_t node = 0;
    uint8_t quantity = 0;
    ScanType type;  // bits 0: the driver does not tell
  };
  MonotonicClock& clock_;
  Place places_[firmware::kMaxNodes * firmware::kQuantities];
  int place_count_ = 0;
  uint64_t period_ns_ = 1000000;
  bool started_ = false;
  uint64_t start_ns_ = 0;
  uint64_t next_ = 0;  // number of the next sample since start
};

}  // namespace hal

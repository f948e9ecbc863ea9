// Samples from an array, released one at a time as a converter would, or withheld and broken on purpose.
#pragma once
#include <cstddef>
#include <vector>

#include "hal/interface/sample_source.hpp"

namespace hal {

enum class SampleFailure {
  kNone,
  kSilent,  // no sample comes any more
  kFault,   // the source answers kFault
  kEnded,   // the source answers kEnd
};

class FakeSampleSource final : public SampleSource {
 public:
  FakeSampleSource() = default;
  explicit FakeSampleSource(std::vector<firmware::RawSample> samples) : samples_(std::move(samples)) {}

  SampleResult read(firmware::RawSample& sample) override;
  uint32_t frames_lost() const override { return frames_lost_; }
  uint32_t overflows() const override { return overflows_; }

  // Makes the next `count` samples of the array ready; after the last one the source answers kEnd.
  void release(size_t count) { ready_ += count; }
  // Puts one sample in front of the controller directly.
  void offer(const firmware::RawSample& sample) {
    offered_ = sample;
    has_offer_ = true;
  }
  void fail(SampleFailure failure) { failure_ = failure; }
  void lose_frames(uint32_t count) { frames_lost_ += count; }
  void overflow(uint32_t count) { overflows_ += count; }

 private:
  std::vector<firmware::RawSample> samples_;
  size_t next_ = 0;
  size_t ready_ = 0;
  firmware::RawSample offered_;
  bool has_offer_ = false;
  SampleFailure failure_ = SampleFailure::kNone;
  uint32_t frames_lost_ = 0;
  uint32_t overflows_ = 0;
};

}  // namespace hal

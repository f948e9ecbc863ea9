// See fake_sample_source.hpp.
#include "hal/fake/fake_sample_source.hpp"

namespace hal {

SampleResult FakeSampleSource::read(firmware::RawSample& sample) {
  switch (failure_) {
    case SampleFailure::kSilent:
      return SampleResult::kNone;
    case SampleFailure::kFault:
      return SampleResult::kFault;
    case SampleFailure::kEnded:
      return SampleResult::kEnd;
    case SampleFailure::kNone:
      break;
  }
  if (has_offer_) {
    sample = offered_;
    has_offer_ = false;
    return SampleResult::kSample;
  }
  if (samples_.empty()) return SampleResult::kNone;
  if (next_ == samples_.size()) return SampleResult::kEnd;
  if (next_ >= ready_) return SampleResult::kNone;
  sample = samples_[next_++];
  return SampleResult::kSample;
}

}  // namespace hal

// Where samples come from: converters, sensor frames on CAN, a recording, a simulated rig.
#pragma once
#include "firmware/acquisition/raw_sample.hpp"

namespace hal {

enum class SampleResult : uint8_t {
  kSample,  // a new sample is in the argument
  kNone,    // none is ready yet
  kEnd,     // there will be no more (recordings and simulations)
  kFault,   // the source failed
};

class SampleSource {
 public:
  virtual SampleResult read(firmware::RawSample& sample) = 0;  // never blocks
  // Parts of samples that never came, where samples come in parts (sensor frames on CAN); since start.
  virtual uint32_t frames_lost() const { return 0; }
  // Samples, or parts of them, that were dropped because read() was called too late; since start.
  virtual uint32_t overflows() const { return 0; }

 protected:
  ~SampleSource() = default;
};

}  // namespace hal

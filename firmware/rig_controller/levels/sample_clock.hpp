// Whether samples come at the rate that the rig was configured with. Nothing in their codes tells: of a displacement alone at half the rate the
// core makes twice the velocity, and half the damper.
#pragma once
#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/fixed_point/scaled.hpp"

namespace firmware {

class SampleClock {
 public:
  void begin_level() { first_ns_ = 0; }
  // A time of 0 is none. A number that goes back is a counter that began anew.
  void take(const RawSample& sample) {
    if (sample.time_ns == 0) return;
    if (first_ns_ == 0 || static_cast<int32_t>(sample.sequence - first_) < 0) {
      first_ns_ = sample.time_ns;
      first_ = sample.sequence;
    }
    last_ns_ = sample.time_ns;
    last_ = sample.sequence;
  }
  // The level's samples have taken another time than their numbers say, by a twentieth and more than they may wait in buffers.
  bool off_rate(const Scaled& sample_period_s) const;

 private:
  uint64_t first_ns_ = 0, last_ns_ = 0;
  uint32_t first_ = 0, last_ = 0;
};

}  // namespace firmware

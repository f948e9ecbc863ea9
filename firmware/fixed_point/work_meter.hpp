// Lets a long calculation be done in slices. What its time goes into reports roughly how many instructions it takes; whoever runs
// the calculation may hold it there and let something else come first (hal/bare_metal/sliced_worker.hpp). The order of the steps
// stays what it is, so the bits do too. Where nobody listens a report is one look at a pointer.
#pragma once
#include <cstdint>

#include "firmware/fixed_point/in_place.hpp"

namespace firmware {

class WorkMeter {
 public:
  void spend(int32_t instructions) {
    left_ -= instructions;
    if (left_ < 0) used_up();
  }

 protected:
  ~WorkMeter() = default;
  virtual void used_up() = 0;  // may return much later
  int32_t left_ = 0;           // instructions of this slice
};

// Of the calculation that runs; nullptr: it runs in one piece. Set by one thread alone, while it runs a slice.
inline WorkMeter* work_meter = nullptr;

// A function so short that a call in it would cost as much as it does hands over, where somebody listens, to one that reports and
// then does the same; the last call of either is a jump.
FIRMWARE_ONCE void report_work(int32_t instructions) {
  if (work_meter != nullptr) work_meter->spend(instructions);
}

}  // namespace firmware

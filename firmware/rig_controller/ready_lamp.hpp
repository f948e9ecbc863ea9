// The lamp that says whether a reason to stand still is latched. It is set when that changes, and again in every step
// until the output takes it.
#pragma once
#include "hal/interface/digital_line.hpp"

namespace firmware {

class ReadyLamp {
 public:
  explicit ReadyLamp(hal::DigitalOutput& lamp) : lamp_(lamp) {}
  void show(bool on) {
    if (known_ && on == on_) return;
    known_ = lamp_.set(on);
    on_ = on;
  }

 private:
  hal::DigitalOutput& lamp_;
  bool on_ = false;
  bool known_ = false;
};

}  // namespace firmware

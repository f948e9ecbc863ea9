// The lamp that says whether a reason to stand still is latched. It is set when that changes, and again in every step
// until the output takes it.
#pragma once
#include "hal/interface/digital_line.hpp"

namespace firmware {

class ReadyLamp {
 public:
  explicit ReadyLamp(hal::DigitalOutput& lamp) : lamp_(lamp) {}
  void show(bool on) {
    const Shown wanted = on ? Shown::kOn : Shown::kOff;
    if (shown_ != wanted) shown_ = lamp_.set(on) ? wanted : Shown::kUnknown;
  }

 private:
  enum class Shown : uint8_t { kOff, kOn, kUnknown };
  hal::DigitalOutput& lamp_;
  Shown shown_ = Shown::kUnknown;
};

}  // namespace firmware

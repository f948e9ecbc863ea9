// Time that only goes forward.
#pragma once
#include <cstdint>

namespace hal {

class MonotonicClock {
 public:
  virtual uint64_t now_ns() = 0;

 protected:
  ~MonotonicClock() = default;
};

}  // namespace hal

// The supervisor outside the program: unless it is fed in time, the board goes to its safe state.
#pragma once

namespace hal {

class Watchdog {
 public:
  virtual void feed() = 0;

 protected:
  ~Watchdog() = default;
};

}  // namespace hal

// The real-time manners of the program: memory that stays, a priority above ordinary processes, a tick that does not
// drift.
#pragma once
#include <cstdint>
#include <string>

#include "hal/linux/system/file_descriptor.hpp"

namespace hal {

// Locks all memory, touches the stack that will be needed, and takes SCHED_FIFO with that priority (0: leaves it).
// Returns what was not granted, in words; empty: all of it.
std::string become_real_time(int priority);

// Ticks at whole periods after its start, whatever happens in between.
class Ticker {
 public:
  bool start(uint64_t period_ns);
  int descriptor() const { return timer_.get(); }
  // Takes the ticks that have passed; more than one means that the program was not run in time.
  void take();
  uint64_t ticks() const { return ticks_; }
  uint64_t missed() const { return missed_; }

 private:
  FileDescriptor timer_;
  uint64_t ticks_ = 0;
  uint64_t missed_ = 0;
};

}  // namespace hal

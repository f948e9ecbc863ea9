// One digital line: emergency stop, sync or tacho edge, shaker-enable relay, ready lamp.
#pragma once
#include <cstdint>

namespace hal {

struct LineEdge {
  bool rising = false;
  uint64_t time_ns = 0;
};

class DigitalInput {
 public:
  virtual bool active() = 0;                   // the logical level, now
  virtual bool next_edge(LineEdge& edge) = 0;  // false: no edge is waiting; never blocks
 protected:
  ~DigitalInput() = default;
};

class DigitalOutput {
 public:
  virtual bool set(bool active) = 0;  // false: not delivered
 protected:
  ~DigitalOutput() = default;
};

}  // namespace hal

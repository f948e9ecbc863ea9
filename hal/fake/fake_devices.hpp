// The small fakes: clock, drive, lines, watchdog. Each records what the controller did and can refuse.
#pragma once
#include <cstdint>
#include <deque>

#include "hal/interface/clock.hpp"
#include "hal/interface/digital_line.hpp"
#include "hal/interface/drive_output.hpp"
#include "hal/interface/watchdog.hpp"

namespace hal {

// Time moves only when told to.
class ManualClock final : public MonotonicClock {
 public:
  uint64_t now_ns() override { return now_ns_; }
  void advance_ns(uint64_t step_ns) { now_ns_ += step_ns; }
  void set_ns(uint64_t now_ns) { now_ns_ = now_ns; }

 private:
  uint64_t now_ns_ = 0;
};

class FakeDrive final : public DriveOutput {
 public:
  bool write(int32_t drive_q31) override {
    if (refuse_) return false;
    drive_q31_ = drive_q31;
    ++writes_;
    return true;
  }
  void refuse(bool refuse) { refuse_ = refuse; }
  int32_t drive_q31() const { return drive_q31_; }
  uint64_t writes() const { return writes_; }

 private:
  bool refuse_ = false;
  int32_t drive_q31_ = 0;
  uint64_t writes_ = 0;
};

class FakeInput final : public DigitalInput {
 public:
  bool active() override { return active_; }
  bool next_edge(LineEdge& edge) override {
    if (edges_.empty()) return false;
    edge = edges_.front();
    edges_.pop_front();
    return true;
  }
  // Changes the level and leaves an edge behind where it did change.
  void set(bool active, uint64_t time_ns) {
    if (active != active_) edges_.push_back({active, time_ns});
    active_ = active;
  }
  // A pulse too short to be seen as a level.
  void pulse(uint64_t time_ns) {
    set(true, time_ns);
    set(false, time_ns);
  }

 private:
  bool active_ = false;
  std::deque<LineEdge> edges_;
};

class FakeOutput final : public DigitalOutput {
 public:
  bool set(bool active) override {
    if (refuse_) return false;
    changes_ += active != active_ ? 1 : 0;
    active_ = active;
    return true;
  }
  void refuse(bool refuse) { refuse_ = refuse; }
  bool active() const { return active_; }
  uint64_t changes() const { return changes_; }

 private:
  bool refuse_ = false;
  bool active_ = false;
  uint64_t changes_ = 0;
};

class FakeWatchdog final : public Watchdog {
 public:
  void feed() override { ++feeds_; }
  uint64_t feeds() const { return feeds_; }

 private:
  uint64_t feeds_ = 0;
};

}  // namespace hal

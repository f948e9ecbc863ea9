// The small fakes: clock, drive, lines, watchdog. Each records what the controller did and can refuse.
#pragma once
#include <algorithm>
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

// When an output does not take what it is told: always, or a number of times.
struct Refusal {
  bool always = false;
  int times = 0;
  bool now() { return always || (times > 0 && times-- > 0); }
};

class FakeDrive final : public DriveOutput {
 public:
  bool write(int32_t drive_q31) override {
    if (refuses_.now()) return false;
    drive_q31_ = drive_q31;
    ++writes_;
    return true;
  }
  void refuse(bool refuse) { refuses_.always = refuse; }
  void refuse_next(int times) { refuses_.times = times; }
  int32_t drive_q31() const { return drive_q31_; }
  uint64_t writes() const { return writes_; }

 private:
  Refusal refuses_;
  int32_t drive_q31_ = 0;
  uint64_t writes_ = 0;
};

// A line that changes when told, or by a script in the middle of whatever reads it: a real line changes between any two
// reads, its level and its edges need not become visible together, and a short pulse may leave one of the two alone.
class FakeInput final : public DigitalInput {
 public:
  enum class Shows : uint8_t { kLevel, kEdge };

  bool active() override {
    run_script();
    seen_ = seen_ || active_;
    return active_;
  }
  bool next_edge(LineEdge& edge) override {
    run_script();
    if (edges_.empty()) return false;
    edge = edges_.front();
    edges_.pop_front();
    seen_ = true;
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

  // Before the read with this number (active() and next_edge() count alike, the first ever is number 0): the level
  // becomes active or not, or an edge in that direction begins to wait. At one read: in the order of calling.
  void at_read(uint64_t read, Shows what, bool active) {
    script_.push_back({read, what, active});
    std::stable_sort(script_.begin(), script_.end(), [](const Change& a, const Change& b) { return a.read < b.read; });
  }
  uint64_t reads() const { return reads_; }
  bool seen() const { return seen_; }  // some read has answered with an active level or an edge
  void forget_what_was_seen() { seen_ = false; }

 private:
  struct Change {
    uint64_t read;
    Shows what;
    bool active;
  };
  void run_script() {
    for (; !script_.empty() && script_.front().read <= reads_; script_.pop_front()) {
      const Change& change = script_.front();
      if (change.what == Shows::kLevel) active_ = change.active;
      if (change.what == Shows::kEdge) edges_.push_back({change.active, 0});
    }
    ++reads_;
  }

  bool active_ = false;
  bool seen_ = false;
  uint64_t reads_ = 0;
  std::deque<LineEdge> edges_;
  std::deque<Change> script_;
};

class FakeOutput final : public DigitalOutput {
 public:
  bool set(bool active) override {
    if (refuses_.now()) return false;
    changes_ += active != active_ ? 1 : 0;
    active_ = active;
    return true;
  }
  void refuse(bool refuse) { refuses_.always = refuse; }
  void refuse_next(int times) { refuses_.times = times; }
  bool active() const { return active_; }
  uint64_t changes() const { return changes_; }

 private:
  Refusal refuses_;
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

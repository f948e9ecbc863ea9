// A CAN bus in memory that records what is sent and fails on purpose.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "hal/interface/can_bus.hpp"
#include "hal/interface/clock.hpp"

namespace hal {

// The ways in which a bus fails.
enum class BusFailure {
  kNone,
  kQueueFull,    // every send answers kQueueFull
  kDown,         // interface down: send and receive answer kBusDown
  kDriverFault,  // every send answers kFault
  kShortQueue,   // the queue takes three frames until drain() is called
};

// Error frames as SocketCAN delivers them.
enum class ErrorFrame { kBusOff, kRestarted, kErrorPassive, kErrorActive, kReceiveOverflow, kNoAcknowledge };
CanFrame make_error_frame(ErrorFrame kind);

class FakeCanBus final : public CanBus {
 public:
  // clock gives sent frames their time stamp.
  explicit FakeCanBus(MonotonicClock& clock) : clock_(clock) {}

  CanResult send(const CanFrame& frame) override;
  CanResult receive(CanFrame& frame) override;
  uint32_t receive_overflows() const override { return receive_overflows_; }

  void overflow(uint32_t frames) { receive_overflows_ += frames; }
  void fail(BusFailure failure) { failure_ = failure; }
  void drain() { queued_ = 0; }
  void inject(const CanFrame& frame) { incoming_.push_back(frame); }
  void inject(ErrorFrame kind) { inject(make_error_frame(kind)); }
  // Keep the frames that are sent (default) or count them only, for long runs with flat memory.
  void keep_frames(bool keep) { keep_ = keep; }

  const std::vector<CanFrame>& sent() const { return sent_; }
  size_t count(uint32_t id) const;
  const CanFrame* last(uint32_t id) const;  // nullptr: none
  uint64_t sent_count() const { return sent_count_; }
  void clear() { sent_.clear(); }

 private:
  MonotonicClock& clock_;
  BusFailure failure_ = BusFailure::kNone;
  size_t queued_ = 0;
  bool keep_ = true;
  uint64_t sent_count_ = 0;
  uint32_t receive_overflows_ = 0;
  std::vector<CanFrame> sent_;
  std::deque<CanFrame> incoming_;
};

}  // namespace hal

// The estimates' worker of a board without an operating system: a solve in slices that the main loop runs between samples.
//
//   for (;;) {
//     controller.step();
//     while (!sample_is_ready()) worker.run_slice();
//   }
//
// A slice ends at the first report of work (firmware/fixed_point/work_meter.hpp) beyond what it may spend: at most some 3000
// instructions later, so a sample waits no longer than that. The order of the steps is that of a solve in one piece: the same bits.
#pragma once
#include "firmware/fixed_point/work_meter.hpp"
#include "hal/bare_metal/coroutine.hpp"
#include "hal/interface/worker.hpp"

namespace hal {

class SlicedWorker final : public Worker, private firmware::WorkMeter {
 public:
  static constexpr int32_t kInstructionsPerSlice = 6000;  // as they are reported

  // stack: as deep as a solve goes (docs/memory_budget.md) and what an interrupt takes; aligned to 8 bytes, outlives this.
  SlicedWorker(uint8_t* stack, size_t size, int32_t instructions_per_slice = kInstructionsPerSlice)
      : coroutine_(stack, size, &SlicedWorker::body, this), per_slice_(instructions_per_slice) {}

  void start(void (*work)(void*), void* argument) override {
    work_ = work;
    argument_ = argument;
    done_ = false;
  }
  bool done() override { return done_; }
  void wait() override {
    while (!done_) run_slice();
  }
  // Goes on with what was begun. Returns at once where that is done.
  void run_slice() {
    if (done_) return;
    left_ = per_slice_;
    firmware::work_meter = this;
    coroutine_.resume();
    firmware::work_meter = nullptr;
  }

 private:
  void used_up() override { coroutine_.yield(); }
  static void body(void* self) {
    auto& own = *static_cast<SlicedWorker*>(self);
    for (;;) {
      own.work_(own.argument_);
      own.done_ = true;
      own.coroutine_.yield();
    }
  }

  Coroutine coroutine_;
  int32_t per_slice_;
  void (*work_)(void*) = nullptr;
  void* argument_ = nullptr;
  bool done_ = true;
};

}  // namespace hal

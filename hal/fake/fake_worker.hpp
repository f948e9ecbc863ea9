// A worker that takes as long as it is told: the work is done when the given number of questions after it have been
// asked, or on command.
#pragma once
#include "hal/interface/worker.hpp"

namespace hal {

class FakeWorker final : public Worker {
 public:
  static constexpr int kUntilTold = -1;

  void start(void (*work)(void*), void* argument) override {
    work_ = work;
    argument_ = argument;
    left_ = takes_;
    ++starts_;
  }
  bool done() override {
    if (work_ != nullptr && left_ >= 0 && left_-- == 0) finish();
    return work_ == nullptr;
  }
  void wait() override {
    ++waits_;
    finish();
  }
  void takes(int questions) { takes_ = questions; }
  void finish() {
    if (work_ != nullptr) work_(argument_);
    work_ = nullptr;
  }
  int starts() const { return starts_; }
  int waits() const { return waits_; }

 private:
  void (*work_)(void*) = nullptr;
  void* argument_ = nullptr;
  int takes_ = 0, left_ = 0, starts_ = 0, waits_ = 0;
};

}  // namespace hal

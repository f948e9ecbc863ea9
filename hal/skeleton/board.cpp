#include "hal/skeleton/board.hpp"

namespace skeleton {

uint64_t Clock::now_ns() {
  // e.g. ticks64() * 1000 / kTicksPerMicrosecond
  static uint64_t pretended_ns = 0;
  return pretended_ns += 1000;
}

void Samples::sample_complete(const firmware::RawSample& sample) {
  const unsigned written = written_.load(std::memory_order_relaxed);
  if (written - taken_.load(std::memory_order_acquire) == kRing) {  // read too late: the jump in the sequence tells too
    dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    return;
  }
  ring_[written % kRing] = sample;
  written_.store(written + 1, std::memory_order_release);
}

hal::SampleResult Samples::read(firmware::RawSample& sample) {
  const unsigned taken = taken_.load(std::memory_order_relaxed);
  if (written_.load(std::memory_order_acquire) == taken) return hal::SampleResult::kNone;
  sample = ring_[taken % kRing];
  taken_.store(taken + 1, std::memory_order_release);
  return hal::SampleResult::kSample;
}

// To a transmit mailbox; all full: kQueueFull.
hal::CanResult Can::send(const hal::CanFrame&) { return hal::CanResult::kBusDown; }
// From the receive ring.
hal::CanResult Can::receive(hal::CanFrame&) { return hal::CanResult::kBusDown; }
// To the converter's register.
bool Drive::write(int32_t) { return false; }
// The pin, with a broken wire as active.
bool StopLine::active() { return true; }
// From the pin's interrupt.
bool StopLine::next_edge(hal::LineEdge&) { return false; }
// To the port's register; true once it is there.
bool Line::set(bool) { return pin_ > 31; }
// The reload key.
void Dog::feed() {}
bool Store::save(const uint8_t*, size_t) { return false; }
size_t Store::load(uint8_t*, size_t) { return 0; }

void LoopWorker::start(void (*work)(void*), void* argument) {
  work_ = work;
  argument_ = argument;
  asked_.store(true, std::memory_order_release);  // after the two: the main loop looks at this first
}

void LoopWorker::run() {
  if (!asked_.load(std::memory_order_acquire)) return;
  work_(argument_);
  asked_.store(false, std::memory_order_release);  // after all that it wrote
}

// Never called by step(). From the main loop there is nothing to wait for but oneself.
void LoopWorker::wait() { run(); }

}  // namespace skeleton

#include "hal/skeleton/board.hpp"

#include <cstring>

namespace skeleton {

uint64_t Clock::now_ns() {
  // e.g. ticks64() * 1000 / kTicksPerMicrosecond
  static uint64_t pretended_ns = 0;
  return pretended_ns += 1000;
}

void Samples::sample_complete(const firmware::RawSample& sample) {
  ring_[written_ % kRing] = sample;
  written_ = written_ + 1;  // after the sample: the reader looks at this first
}

hal::SampleResult Samples::read(firmware::RawSample& sample) {
  const unsigned written = written_;
  if (written == taken_) return hal::SampleResult::kNone;
  if (written - taken_ > kRing / 2) taken_ = written - kRing / 2;  // read too late: the jump in the sequence tells
  sample = ring_[taken_ % kRing];
  ++taken_;
  return hal::SampleResult::kSample;
}

hal::CanResult Can::send(const hal::CanFrame&) {
  return hal::CanResult::kDone;
}  // to a transmit mailbox; all full: kQueueFull
hal::CanResult Can::receive(hal::CanFrame&) { return hal::CanResult::kEmpty; }  // from the receive ring
bool Drive::write(int32_t) { return true; }                                     // to the converter's register
bool StopLine::active() { return false; }                                       // the pin, with a broken wire as active
bool StopLine::next_edge(hal::LineEdge&) { return false; }                      // from the pin's interrupt
bool Line::set(bool) { return pin_ < 32; }                                      // to the port's register
void Dog::feed() {}                                                             // the reload key
bool Store::save(const uint8_t*, size_t) { return false; }
size_t Store::load(uint8_t*, size_t) { return 0; }

}  // namespace skeleton

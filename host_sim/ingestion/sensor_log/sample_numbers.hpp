// Samples of a log, numbered over pauses in which a 16-bit sequence may have gone round.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace host_sim {

class SampleNumbers {
 public:
  // Whether so much time has passed from one frame to the next that the sequence no longer tells how many samples are missing: half a round
  // of 16 bits may be over. What assembles frames has to begin anew then. False as long as too few samples tell the period.
  bool is_pause(uint64_t from_ns, uint64_t to_ns) const;
  // The next sample's number: the one of that sequence (16 bits of it) that is nearest to where the time is, at the period so far; where that
  // is not known, or no time has passed, the one after the last by what the sequence says.
  uint32_t take(uint32_t sequence, uint64_t time_ns);

  const std::vector<uint32_t>& numbers() const { return numbers_; }
  uint64_t first_ns() const { return first_ns_; }
  uint64_t last_ns() const { return last_ns_; }

 private:
  double period_ns() const;  // 0: not known yet
  std::vector<uint32_t> numbers_;
  uint64_t first_ns_ = 0, last_ns_ = 0;
};

}  // namespace host_sim

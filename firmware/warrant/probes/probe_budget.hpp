// What the score tests may cost, in products of two numbers a sample.
//
// A wrong term of the model has to be seen before it bends a coefficient by 5 %, and that is a matter of the samples that the
// tests have looked at, not of how many there are. So the default looks at every sample of a level's start; what follows makes the
// estimates finer, and the tests look at a share of it that costs little.
#pragma once
#include "firmware/configuration/configuration.hpp"

namespace firmware {

class ProbeBudget {
 public:
  // Of every level: half a minute at 1 kHz. The shortest records that engineers trust are of that length, and there 5 % are seen
  // (docs/warrant.md); the exact sums of the table merge no earlier than without a limit.
  static constexpr uint32_t kWholeSamples = 32768;

  void configure(const CoreConfiguration& configuration) {
    wanted_ = configuration.probe_products_per_sample;
    products_ = wanted_ == kDefaultProbes ? of_a_long_level(configuration.dof_count) : wanted_;
  }
  // Every candidate on every sample, at this time of the level.
  bool whole(uint32_t samples) const {
    return wanted_ == kAllProbes || (wanted_ == kDefaultProbes && samples < kWholeSamples);
  }
  uint32_t products() const { return products_; }

  // With these the core takes at most 1.6 times what it takes without tests (tests/bench/bench_core.cpp measures it): one of few
  // DOFs has fewer products itself.
  static constexpr uint32_t of_a_long_level(int dof_count) { return 12 + 4 * static_cast<uint32_t>(dof_count); }

 private:
  uint16_t wanted_ = kAllProbes;
  uint32_t products_ = 0;
};

}  // namespace firmware

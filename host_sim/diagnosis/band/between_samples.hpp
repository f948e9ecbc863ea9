// What a channel shows between its samples.
#pragma once
#include <array>

#include "../motion/prepared.hpp"

namespace diagnosis::runs {

// A band-limited series at one share of the way from a sample to the next: a sine cardinal under a Kaiser window of 16 samples either
// way. Right to 1e-6 of what is slower than 0.37 of the sampling rate (its window's side lobes lie 120 dB down); a six-point
// polynomial loses 5 % of a force of a quarter of the sampling rate, which a fit takes for a gain. Within 16 samples of an end: that
// polynomial.
class BetweenSamples {
 public:
  explicit BetweenSamples(double share);  // 0 to 1
  double after(const Vec& y, Index sample) const;

 private:
  static constexpr Index kReach = 16;
  std::array<double, 2 * kReach> tap_;
  double share_;
};

// Value between samples of a series that is finely sampled: six-point Lagrange.
double between(const Vec& y, Index sample, double share);

// Delays `y` by a whole or broken number of samples (ends repeat).
Vec delayed(const Vec& y, double samples);

// `per` values for each sample but the last.
Vec finer(const Vec& y, Index per);

}  // namespace diagnosis::runs

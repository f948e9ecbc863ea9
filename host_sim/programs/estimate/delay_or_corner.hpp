// Whether an acceleration that leads its displacement is early, or has passed a high-pass. A delay turns the phase in proportion to the
// frequency, a high-pass in proportion to its inverse: a record of one frequency does not tell them apart, and a wide one does.
#pragma once
#include <cstddef>
#include <vector>

namespace host_sim {

// Means over the records, each weighted by what it knows.
class DelayAndCorner {
 public:
  // of_x, of_a: both sides of x'' = a at every sample, under one weight.
  void add(const std::vector<double>& of_x, const std::vector<double>& of_a, double sample_period_s);
  // Beside a high-pass the delay is still needed, and no high-pass is needed beside it.
  bool is_a_delay() const;

 private:
  struct Mean {
    double sum = 0.0, weight = 0.0;
    void add(double value, double variance);
    double deviations() const;
  };
  Mean late_s_, corner_;
  double delay_square_ = 0.0, corner_square_ = 0.0;  // of the acceleration: what each of them alone explains
};

}  // namespace host_sim

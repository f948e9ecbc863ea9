// What a simulation misses of a measurement, summed up over stretches of its records.
#pragma once
#include <cmath>

#include "../residual/motion_error.hpp"
#include "score.hpp"

namespace diagnosis::runs {

struct ErrorSums {
  double error = 0, count = 0;
  double motion = 0;  // sum of squares that stands for that about the mean; 0: none does
  void add(const Vec& simulated, const Vec& measured) {
    error += (simulated - measured).squaredNorm(), square_ += measured.squaredNorm(), sum_ += measured.sum();
    count += static_cast<double>(measured.size()), in_record_ += static_cast<double>(measured.size());
  }
  // counted: 1, or 0 for samples that are left out.
  void add(const Vec& simulated, const Vec& measured, const Vec& counted) {
    add(simulated.cwiseProduct(counted), measured.cwiseProduct(counted));
    const double left_out = static_cast<double>(measured.size()) - counted.sum();
    count -= left_out, in_record_ -= left_out;
  }
  // Each record has a mean of its own: an encoder counts on from one to the next.
  void end_record() {
    if (in_record_ > 0) about_means_ += square_ - sum_ * sum_ / in_record_;
    square_ = sum_ = in_record_ = 0;
  }
  double mean_error() const { return count > 0 ? error / count : 0; }
  double variance() const { return (motion > 0 ? motion : about_means_) / count; }
  double ratio() const { return variance() > 0 ? error / count / variance() : 0; }  // mean square over variance
  // The same without what the channel's steps make of both.
  double ratio_beyond(double of_steps) const {
    const double moves = variance() - of_steps;
    return moves > 0 ? std::max(0.0, error / count - of_steps) / moves : ratio();
  }
  bool shows(double noise) const { return variance() > kShown * noise; }

 private:
  double square_ = 0, sum_ = 0, in_record_ = 0;  // of the record that is being summed
  double about_means_ = 0;                       // sums of squares of those before
};

struct DofErrors {
  ErrorSums x, v, a;  // x: of what is measured of the DOF
  ErrorSums driven;   // what noise of the drives makes of x
  double force = 0;   // sum of squares of a force along the motion
  double noise = 0;   // variance, of what stands in x
  double steps = 0;   // of that, what the channel's steps make
};

// A force that does not vary, as of a shaft at constant speed, is missed by a share of itself: about its mean there is nothing to miss, and
// any model would be right.
void count_steady_force(DofErrors& of);

// finite: the runs stayed so.
Score score_of(const std::vector<DofErrors>& dofs, bool finite);

}  // namespace diagnosis::runs

// What a simulation misses of a measurement, summed up over stretches of it.
#pragma once
#include <cmath>

#include "../residual/motion_error.hpp"
#include "score.hpp"

namespace diagnosis::runs {

struct ErrorSums {
  double error = 0, square = 0, sum = 0, count = 0;
  double motion = 0;  // sum of squares that stands for that about the mean; 0: none does
  void add(const Vec& simulated, const Vec& measured) {
    error += (simulated - measured).squaredNorm(), square += measured.squaredNorm(), sum += measured.sum();
    count += static_cast<double>(measured.size());
  }
  // counted: 1, or 0 for samples that are left out.
  void add(const Vec& simulated, const Vec& measured, const Vec& counted) {
    add(simulated.cwiseProduct(counted), measured.cwiseProduct(counted));
    count -= static_cast<double>(measured.size()) - counted.sum();
  }
  double mean_error() const { return count > 0 ? error / count : 0; }
  double variance() const { return motion > 0 ? motion / count : square / count - std::pow(sum / count, 2); }
  double ratio() const { return variance() > 0 ? error / count / variance() : 0; }  // mean square over variance
  // The same without what the channel's steps make of both.
  double ratio_beyond(double of_steps) const {
    const double moves = variance() - of_steps;
    return moves > 0 ? std::max(0.0, error / count - of_steps) / moves : ratio();
  }
  bool shows(double noise) const { return variance() > kShown * noise; }
};

struct DofErrors {
  ErrorSums x, v, a;  // x: of what is measured of the DOF
  ErrorSums driven;   // what noise of the drives makes of x
  double noise = 0;   // variance, of what stands in x
  double steps = 0;   // of that, what the channel's steps make
};

// finite: the runs stayed so.
Score score_of(const std::vector<DofErrors>& dofs, bool finite);

}  // namespace diagnosis::runs

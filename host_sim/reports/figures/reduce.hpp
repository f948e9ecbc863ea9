// Long signals made small enough to draw, without hiding what they do.
#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include "host_sim/reports/figures/plot.hpp"

namespace host_sim::reports {

// A part of a signal: samples [first, first + count).
struct Span {
  size_t first = 0, count = 0;
};

// At most 2 * columns points: the smallest and the largest value of each column in the order in which they occur, so
// that no peak is lost. A signal that fits is kept as it is.
Curve envelope_line(const std::vector<double>& y, Span span, double start_s, double period_s, size_t columns);

// The smallest and the largest value of each column as a band.
Curve envelope_band(const std::vector<double>& y, Span span, double start_s, double period_s, size_t columns);

// Median of y, and its 10 % and 90 % quantiles, over `bins` equal steps of x; bins of fewer than 5 samples are left
// out.
struct Binned {
  std::vector<double> x, median, low, high;
};
Binned binned(const std::vector<double>& x, const std::vector<double>& y, size_t bins);

// `cycles` mean periods (from upward crossings of the mean) long, where |a - b| is largest; for the eye to compare
// curves.
Span most_different(const std::vector<double>& a, const std::vector<double>& b, double cycles);

}  // namespace host_sim::reports

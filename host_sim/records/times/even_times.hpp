// Times as files have them: rounded, of so many digits, of single precision, or stamped by another clock.
#pragma once
#include <cstddef>
#include <vector>

namespace host_sim {

// Least squares of t[i] = start + index[i] step, and what is left, s. As many times as indices, two at least.
struct TimeLine {
  double start = 0.0, step = 0.0, rms = 0.0;
};
TimeLine line_through(const std::vector<double>& time_s, const std::vector<double>& index);

// 0, 1, 2, ... as the indices of a line.
std::vector<double> counted(size_t samples);

// Times that are even but for their last decimal (rounded, or read from a clock of whole ticks), made even. Where the
// last decimal is a quarter of a step or less, or all other steps are the same, samples may be lost between them.
struct EvenTimes {
  double step_s = 0.0, place_s = 0.0;  // 0: they are not even; place: of the last decimal
  bool lost = false;
  std::vector<double> time_s;
};
EvenTimes even_times(const std::vector<double>& time_s);

// The usual step between times, the median; at least two of them.
double median_step(const std::vector<double>& time_s);

// Weights of so many samples at the instant t, of the polynomial that passes through them (Lagrange).
void weights_at(const double* time_s, size_t points, double t, double* weight);

}  // namespace host_sim

// Power spectral density for the eye (Welch: Hann windows, half overlap, one-sided).
#pragma once
#include <cstddef>
#include <vector>

namespace host_sim::reports {

struct Spectrum {
  std::vector<double> frequency_Hz;  // without 0
  std::vector<double> density;       // unit^2 / Hz
};

// Segments of the largest power of two that leaves at least 8 of them, at most 4096 samples, at least 64 (or the
// record). The mean of each segment is removed. Sum of density times bin width is the variance of the signal.
Spectrum power_spectrum(const std::vector<double>& values, double sample_period_s);

// At most `points` values: the largest of each group of equal width, so that a line spectrum keeps its peaks.
Spectrum reduced(const Spectrum& spectrum, size_t points);

}  // namespace host_sim::reports

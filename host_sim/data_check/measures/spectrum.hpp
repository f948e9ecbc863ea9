// Power spectra of channels.
#pragma once
#include <cstddef>
#include <vector>

namespace host_sim::data_check {

// The longest part of a record whose length has the prime factors 2, 3, 5 and 7 alone: at others a transform takes many
// times as long. It leaves out less than 3 % of 64 samples and more.
size_t quick_length(size_t samples);

// Power of each bin of n values from `from` on, the mean taken off, under a Hann window.
std::vector<double> power_spectrum(const double* from, size_t n, double mean);

// The median of the bins [first, last), at least one: the level of noise, which lines do not raise.
double median_power(const std::vector<double>& power, size_t first, size_t last);

}  // namespace host_sim::data_check

// Derivatives of noisy samples under a bell: six boxes of h samples, one after the other, some of them replaced by
// differences. bell(y, k, h, T) is the bell-weighted mean of the k-th derivative of y, exact for every k alike but for
// the trapezoids of the boxes, (omega T)^2 / 12.
#pragma once
#include <cstddef>
#include <vector>

namespace host_sim::data_check {

constexpr int kBoxes = 6;

// h even; k 0 to 6. The result has 6 h samples fewer than y; its first belongs to sample 3 h.
std::vector<double> bell(const std::vector<double>& y, int k, size_t h, double sample_period_s);

// From every h-th sample of bell(y, k, h, T) every 2h-th of bell(y, k, 2h, T): a box of 2h samples, and a difference over
// them, is the mean of two of h.
std::vector<double> twice_as_wide(const std::vector<double>& thinned);

}  // namespace host_sim::data_check

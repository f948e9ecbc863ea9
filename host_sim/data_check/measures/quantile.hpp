// Quantiles of a channel's values.
#pragma once
#include <utility>
#include <vector>

namespace host_sim::data_check {

// The value that floor(q (n - 1)) of the n values are below once sorted, q from 0 to 1, in their unit; 0 of nothing. Values: no NaN.
//
// Two of a sample bracket it; one pass counts what is below the bracket and keeps what is inside, in which it is then looked
// for in the same way (R. W. Floyd, R. L. Rivest, "Expected time bounds for selection", Communications of the ACM 18(3), 1975).
double quantile(const std::vector<double>& values, double q);

// Two of them.
std::pair<double, double> quantiles(const std::vector<double>& values, double low, double high);

}  // namespace host_sim::data_check

// Times of samples that are not even: where, and what to do about it, all at once.
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace host_sim {

constexpr double kStepTolerance = 0.01;        // of the usual step
using LineOf = std::function<size_t(size_t)>;  // where a sample stands in its file

// The first sample whose step is off the usual one by more than the tolerance; the number of samples where none is. Two at least.
size_t first_uneven(const std::vector<double>& time_s);

// What follows behind "expected a constant step": rows in disorder, rows of one time, a clock of arrival, an interpolation.
std::string remedy_of_uneven(const std::vector<double>& time_s, const LineOf& line_of);

// What follows behind "expected times that rise", of times that do not: --resample was given.
std::string remedy_of_falling(const std::vector<double>& time_s, const LineOf& line_of);

}  // namespace host_sim

// How long a swing to and fro takes.
#pragma once
#include <vector>

namespace host_sim::data_check {

// In samples: twice the usual time from a swing to one side of the mean to a swing to the other. 0: fewer than four.
double period_of(const std::vector<double>& y);

// The longest of any eighth whose mean square is at least that share of the loudest eighth's. 0: fewer than four swings in all of them.
double slowest_period_of(const std::vector<double>& y, double share);

}  // namespace host_sim::data_check

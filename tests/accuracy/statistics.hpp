// Many draws of one case, summed up per unknown. Percentages are of the true value.
#pragma once
#include <string>
#include <vector>

#include "tests/accuracy/cases.hpp"

namespace accuracy {

struct ParameterStatistics {
  std::string name;
  double truth = 0.0;
  double bias_percent = 0.0, deviation_percent = 0.0, rms_percent = 0.0;
  double bound_rows_percent = 0.0, bound_identities_percent = 0.0;
  double coverage_percent = 0.0;    // share of draws whose 95 % interval holds the truth
  double quoted_percent = 0.0;      // root mean square of the standard deviation that the estimator gives
  double plain_bias_percent = 0.0;  // of the plain product in place of the instrument
  double direct_bias_percent = 0.0, direct_rms_percent = 0.0;  // least squares of the sampled equations of motion
  int not_valid = 0;                                           // draws in which the status was not VALID
};

struct CaseStatistics {
  std::vector<ParameterStatistics> parameters;
  int draws = 0;
};

CaseStatistics measure_case(const host_sim::Scenario& scenario, uint64_t first_seed, int draws);
// Worst error of the clean run, percent.
double clean_error_percent(const host_sim::Scenario& scenario);

}  // namespace accuracy

#include "tests/accuracy/statistics.hpp"

#include <algorithm>
#include <cmath>

#include "tests/accuracy/bound.hpp"
#include "tests/accuracy/direct_fit.hpp"
#include "tests/accuracy/redraw.hpp"

namespace accuracy {
namespace {

struct Sums {
  double error = 0.0, square = 0.0, quoted_square = 0.0, plain = 0.0, direct = 0.0, direct_square = 0.0;
  int held = 0, not_valid = 0;
};

void add(const firmware::ParameterEstimate& estimate, double truth, double direct, Sums& sums) {
  const auto relative = [&](double value) { return value / truth - 1.0; };
  const double error = relative(rig_file::to_double(estimate.value));
  sums.error += error;
  sums.square += error * error;
  const double quoted = rig_file::to_double(estimate.std) / truth;
  sums.quoted_square += quoted * quoted;
  sums.plain += relative(rig_file::to_double(estimate.plain_value));
  sums.direct += relative(direct);
  sums.direct_square += relative(direct) * relative(direct);
  if (rig_file::to_double(estimate.ci95_low) <= truth && truth <= rig_file::to_double(estimate.ci95_high)) ++sums.held;
  if (estimate.status != firmware::EstimateStatus::kValid) ++sums.not_valid;
}

ParameterStatistics summarise(const Sums& sums, int draws) {
  ParameterStatistics result;
  const double n = draws;
  const double mean = sums.error / n;
  result.bias_percent = 100.0 * mean;
  result.deviation_percent = 100.0 * std::sqrt((sums.square - n * mean * mean) / (n - 1.0));
  result.rms_percent = 100.0 * std::sqrt(sums.square / n);
  result.coverage_percent = 100.0 * sums.held / n;
  result.quoted_percent = 100.0 * std::sqrt(sums.quoted_square / n);
  result.plain_bias_percent = 100.0 * sums.plain / n;
  result.direct_bias_percent = 100.0 * sums.direct / n;
  result.direct_rms_percent = 100.0 * std::sqrt(sums.direct_square / n);
  result.not_valid = sums.not_valid;
  return result;
}

}  // namespace

CaseStatistics measure_case(const host_sim::Scenario& scenario, uint64_t first_seed, int draws) {
  Redraw redraw(scenario);
  redraw.run(0, false);
  Bound bound(redraw.table(), scenario.truth);
  std::vector<Sums> sums(scenario.truth.size());
  for (int d = 0; d < draws; ++d) {
    const firmware::Estimates& estimates = redraw.run(first_seed + static_cast<uint64_t>(d));
    bound.add(redraw.table());
    const std::vector<double> direct = direct_fit(scenario.rig, redraw.records());
    for (size_t k = 0; k < sums.size(); ++k) add(estimates.parameters[k], scenario.truth[k], direct[k], sums[k]);
  }
  CaseStatistics result;
  result.draws = draws;
  const std::vector<std::string> names = rig_file::parameter_names(scenario.rig);
  const std::vector<double> rows = bound.rows(), identities = bound.identities();
  for (size_t k = 0; k < sums.size(); ++k) {
    result.parameters.push_back(summarise(sums[k], draws));
    ParameterStatistics& parameter = result.parameters.back();
    parameter.name = names[k];
    parameter.truth = scenario.truth[k];
    parameter.bound_rows_percent = 100.0 * rows[k] / std::fabs(scenario.truth[k]);
    parameter.bound_identities_percent = 100.0 * identities[k] / std::fabs(scenario.truth[k]);
  }
  return result;
}

double clean_error_percent(const host_sim::Scenario& scenario) {
  Redraw redraw(scenario);
  const firmware::Estimates& estimates = redraw.run(0, false);
  double worst = 0.0;
  for (size_t k = 0; k < scenario.truth.size(); ++k)
    worst = std::max(worst,
                     std::fabs(rig_file::to_double(estimates.parameters[k].value) / scenario.truth[k] - 1.0) * 100.0);
  return worst;
}

}  // namespace accuracy

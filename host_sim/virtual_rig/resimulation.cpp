#include "host_sim/virtual_rig/resimulation.hpp"

#include <cmath>
#include <future>
#include <limits>
#include <numeric>

#include "host_sim/plant/instruments/shaker.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim {
namespace {

Scenario with_estimates(const Scenario& scenario, const RunResult& result) {
  std::vector<double> values;
  for (const RunParameter& parameter : result.parameters) values.push_back(parameter.value);
  Scenario estimated = scenario;
  estimated.plant = rig_file::with_values(scenario.rig, values);
  return estimated;
}

// Eq. 13 of one DOF over the measured part of all levels: N sigma^2 is the sum of squared deviations from each level's
// mean.
double mean_square_error(const Scenario& scenario, const RunResult& result, int dof) {
  const std::vector<Record>& truth = result.measured.truth;
  double error = 0.0, deviation = 0.0;
  for (size_t level = 0; level < truth.size(); ++level) {
    const size_t from = scenario.levels[level].settle_samples, count = scenario.levels[level].samples;
    const double* a = truth[level].find(Quantity::kAcceleration, dof)->values.data() + from;
    const double* b = result.resimulated[level].find(Quantity::kAcceleration, dof)->values.data() + from;
    const double mean = std::accumulate(a, a + count, 0.0) / static_cast<double>(count);
    for (size_t k = 0; k < count; ++k) {
      error += (a[k] - b[k]) * (a[k] - b[k]);
      deviation += (a[k] - mean) * (a[k] - mean);
    }
  }
  return deviation > 0.0 ? 100.0 * error / deviation : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void judge_by_resimulation(const Scenario& scenario, RunResult& result) {
  result.mse_percent.assign(scenario.rig.dofs.size(), std::numeric_limits<double>::quiet_NaN());
  try {
    const Scenario estimated = with_estimates(scenario, result);
    std::vector<std::future<Record>> levels;
    for (size_t level = 0; level < scenario.levels.size(); ++level)
      levels.push_back(std::async(std::launch::async, [&estimated, &result, level] {
        return simulate_level(estimated, level, result.measured.excitation[level]);
      }));
    for (std::future<Record>& level : levels) result.resimulated.push_back(level.get());
    for (size_t i = 0; i < result.mse_percent.size(); ++i)
      result.mse_percent[i] = mean_square_error(scenario, result, static_cast<int>(i + 1));
  } catch (const PlantError& error) {
    result.mse_note = std::string("the rig with the estimates cannot be simulated: ") + error.what();
    result.resimulated.clear();
  }
}

}  // namespace host_sim

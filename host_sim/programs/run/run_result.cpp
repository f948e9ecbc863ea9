#include "host_sim/programs/run/run_result.hpp"

#include <cmath>

#include "host_sim/programs/run/paper_figures.hpp"

namespace host_sim {

EstimateResult result_of_run(const Scenario& scenario, const RunResult& run) {
  EstimateResult result = result_of(scenario.rig, run.estimates, run.measured.measured);
  for (size_t i = 0; i < result.parameters.size(); ++i) result.parameters[i].truth = scenario.truth[i];
  for (const double mse : run.mse_percent)
    result.mse_percent.push_back(std::isfinite(mse) ? std::optional<double>(mse) : std::nullopt);
  result.mse_of = "noise-free acceleration against the simulation with the estimates";
  result.mse_note = run.mse_note;
  result.samples = run.samples;
  result.sample_rate_Hz = run.sample_rate_Hz;
  result.levels = static_cast<unsigned>(scenario.levels.size());
  result.health = run.health;
  add_paper_figures(scenario.name, result);
  return result;
}

}  // namespace host_sim

// Many runs of scenarios, spread over processes: every run is independent, so results do not depend on how they are
// spread.
#pragma once
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace host_sim {

struct SweepTask {
  std::string scenario;
  uint64_t seed = 0;
};

// Scenario by scenario, seed by seed.
std::vector<SweepTask> sweep_tasks(const std::vector<std::string>& scenarios, uint64_t first_seed, uint64_t last_seed);

// One run as JSON: scenario, seed, parameters (name, unit, truth, value, std, ci95, status), residual_mean_abs,
// mse_percent.
nlohmann::ordered_json sweep_run(const SweepTask& task);

// Runs all tasks in `workers` child processes and returns their JSON in the order of the tasks. done is told how many
// are finished. Throws std::runtime_error with a worker's message where one fails.
std::vector<nlohmann::ordered_json> run_in_parallel(const std::vector<SweepTask>& tasks, unsigned workers,
                                                    const std::function<void(size_t)>& done);

}  // namespace host_sim

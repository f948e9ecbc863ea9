// A scenario from shaker to estimates: what `host_sim run` does, without its command line.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "firmware/estimator_core.hpp"
#include "hal/interface/can_bus.hpp"
#include "host_sim/virtual_rig/virtual_rig.hpp"

namespace host_sim {

// Told of the run as it goes on; simulated time counts from the first sample of the first level.
class ProgressSink {
 public:
  virtual ~ProgressSink() = default;
  // Before the first sample, with what the core was configured with (which lives until run_scenario returns).
  virtual void begin(const Scenario&, const firmware::CoreConfiguration&) {}
  virtual void progress(double /*share of all samples, 0 to 1*/) {}
  virtual void frame(const hal::CanFrame&) {}  // sent by the controller at frame.time_ns, in order
  // Every second of simulated time while a level is measured, at the end of each level, and once more at the end
  // (last).
  virtual void window(uint64_t /*time_ns*/, const firmware::Estimates&, const firmware::CoreHealth&, bool /*last*/) {}
};

struct RunParameter {
  rig_file::ParameterInfo info;
  double truth = 0.0, value = 0.0, std = 0.0, ci95_low = 0.0, ci95_high = 0.0;
  firmware::EstimateStatus status = firmware::EstimateStatus::kStale;
};

struct RunResult {
  std::vector<RunParameter> parameters;  // in the order of the core's unknowns
  double residual_mean_abs = 0.0;        // mean |A p - U| / |U|, the paper's normalised residual
  double condition_number = 0.0;
  // Eq. 13 per DOF, all levels together: noise-free acceleration of the simulated rig against that of the rig with the
  // estimates, under the same excitation from the same start (the paper compares the same two). NaN where the rig with
  // the estimates cannot be simulated; mse_note says why.
  std::vector<double> mse_percent;
  std::string mse_note;
  size_t samples = 0;  // fed to the core
  double sample_rate_Hz = 0.0;
  uint32_t rows = 0;
  firmware::CoreHealth health;
  firmware::Estimates estimates;    // as the core gave them
  MeasuredLevels measured;          // for pictures: settling and run-out are in
  std::vector<Record> resimulated;  // per level, the rig with the estimates; empty where it cannot be simulated
};

// Whole cycles where every level is a sine whose cycle (or a common multiple of them) is a whole number of samples and
// fits into the shortest level; free decay where all are; else arbitrary intervals (Eq. 12a), whose first batches are as long as
// the shortest level allows (hal/rig_file/first_batches.hpp).
firmware::WindowConfiguration scenario_window(const Scenario& scenario);

// Throws PlantError (the rig cannot be simulated) and rig_file::RigFileError (beyond the core's capacity).
RunResult run_scenario(const Scenario& scenario, uint64_t seed, ProgressSink& sink);

}  // namespace host_sim

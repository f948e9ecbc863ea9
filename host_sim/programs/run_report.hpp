// What `run --report` shows: the counterparts of the paper's figures.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host_sim/programs/estimate_result.hpp"
#include "host_sim/virtual_rig/run_scenario.hpp"

namespace host_sim {

// Every window's estimates, in the order in which the windows closed.
class ConvergenceRecorder {
 public:
  struct Point {
    double value, low, high;
  };
  void add(uint64_t time_ns, const firmware::Estimates& estimates);
  const std::vector<double>& time_s() const { return time_s_; }
  const std::vector<Point>& points(size_t parameter) const { return points_[parameter]; }

 private:
  std::vector<double> time_s_;
  std::vector<std::vector<Point>> points_;  // [parameter][window]
};

// Throws std::runtime_error where gnuplot is missing or the folder cannot be written.
void write_run_report_of(const std::string& folder, const Scenario& scenario, uint64_t seed, const RunResult& run,
                         const EstimateResult& result, const ConvergenceRecorder& convergence);

}  // namespace host_sim

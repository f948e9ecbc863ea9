// What the page of a simulated run shows.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/reports/data/rig_view_data.hpp"
#include "host_sim/reports/data/warrant_view.hpp"

namespace host_sim::reports {

// An estimate as the windows close: vectors of one length.
struct Convergence {
  std::vector<double> time_s, value, low, high;
};

struct RunParameter {
  std::string name, unit, status;
  double truth;  // NaN: not known
  Interval estimate;
  Convergence convergence;
};

// A channel before and after the sensors; vectors of one length.
struct RunChannel {
  std::string name, unit;  // "force 1", "N"
  std::vector<double> clean, contaminated;
};

// Acceleration of a DOF and its simulation with the estimates in place of the truth.
struct RunAcceleration {
  int dof = 1;
  std::string unit = "m/s^2";
  double mse_percent;  // Eq. 13
  std::vector<double> measured, simulated;
};

// One excitation level or frequency of the scenario; time of sample i is start_s + i * period_s.
struct RunRecord {
  std::string label;  // "rms 10 N, 5 to 50 Hz"
  double start_s = 0.0, period_s = 0.0;
  std::vector<RunChannel> channels;
  std::vector<RunAcceleration> accelerations;
};

struct RunReportData {
  std::string scenario;
  std::vector<std::string> facts;  // "seed 1", "1000 Hz", ...
  double condition_number, residual_mean_abs;
  std::vector<RunParameter> parameters;
  std::vector<RunRecord> records;
  RigViews views;
  std::optional<WarrantView> warrant;
  std::optional<data_check::Report> check;
};

}  // namespace host_sim::reports

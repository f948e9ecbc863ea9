// How well a model simulates data that its fit has not seen.
#pragma once
#include "../windows/state.hpp"

namespace diagnosis::runs {

constexpr double kHalfOfVariance = 70.7;  // NRMSE in percent: a run misses half of the variance

// A model's free run on unseen data, from the measured state at its start; errors over 1000 % are said as 1000.
struct Score {
  std::vector<double> nrmse_percent, velocity_percent, mse_percent;  // per DOF
  std::vector<double> by_steps_percent;  // per DOF: of nrmse_percent, what the steps of its channel alone make
  double beyond_noise_percent = 0;       // of the DOF of which most is missed beyond noise, of channel and drives
  double worst_percent = 0;              // of DOFs whose unseen motion its channel shows, beyond those steps
  double by_drives_percent =
      0;  // of that DOF: what another noise of the channels that drive the rig would make of its run
};
Score score_unseen(const Task& task, const State& state, const Vec* noise = nullptr);
// The same of one record, whether a fit has seen it or not.
Score score_record(const Task& task, const State& state, size_t record, const Vec& noise);

}  // namespace diagnosis::runs

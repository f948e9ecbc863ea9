// Output error over windows with free states: Gauss-Newton on the sum over channels of the logarithm of the mean square.
#pragma once
#include "evaluator.hpp"

namespace diagnosis::runs {

struct Fitted {
  bool ok = false;
  double cost = 0;             // sum over channels of N/2 log(mean square)
  Vec mean_square;             // per channel, over the windows of the fit
  std::vector<Vec> window_ss;  // per window: square sum per channel
  std::vector<Mat> gram;       // per window: parameters' normal matrix beside the free state, weighted
  std::vector<Vec> score;      // per window: its right-hand side
  double total_rows = 0;       // of all channels
};

// How each parameter is determined: block influences over the windows, corrected for leverage.
struct Determined {
  double std = 0;  // of the parameter, so that value +- 1.96 std is its 95 % interval
  double z = 0;    // value over standard error, as a normal deviate
};
std::vector<Determined> determined(const Fitted& fit, const Model& model);

// Fits the model's free numbers and the states of the windows; `only_states` leaves the numbers alone.
Fitted fit(const System& system, const std::vector<Prepared>& records, Model& model, std::vector<Window>& windows,
           int iterations, bool only_states = false);

// A normal deviate as unlikely as t of Student's law.
double normal_deviate(double t, double dof);

}  // namespace diagnosis::runs

// What is said of a choice: the contract's fields.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Causes, rivals, both models' parameters, their free runs on unseen data, the extended rig, the remainder and the
// verdict.
void answer(const Task& task, const Choice& choice, Diagnosis& d);

// Widens intervals to those that a fit of free runs gives the same coefficients: its standard deviations come from the
// scatter of what is left, window by window, and know of what a model of the noise leaves out.
void widen(const Task& task, const State& fitted, std::vector<diagnosis::Parameter>& parameters);

// A delay of the force that is half a sample early is named as what it is: the force is held between its samples.
void name_holds(const Task& task, Diagnosis& d);

// Scores two models on unseen data: the rig as given and that with the causes. `noise`: mean square of each channel's. Returns
// the second's worst NRMSE in percent where a channel shows motion beyond it.
double compare_unseen(const Task& task, const State& base, const State& with_causes, bool any_cause, const Vec& noise,
                      Diagnosis& d);

// A model's free run on unseen data, from the measured state at its start; errors over 1000 % are said as 1000.
struct Score {
  std::vector<double> nrmse_percent, velocity_percent, mse_percent;  // per DOF
  double worst_percent = 0;                                          // of DOFs whose unseen motion its channel shows
};
Score score_unseen(const Task& task, const State& state, const Vec* noise = nullptr);

}  // namespace diagnosis::runs

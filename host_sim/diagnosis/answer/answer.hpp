// What is said of a choice: the contract's fields.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Causes, rivals, both models' parameters, their free runs on unseen data, the extended rig, the remainder and the
// verdict.
void answer(const Task& task, const Choice& choice, Diagnosis& d);

// The coefficients of a fit of free runs: its standard deviations come from the scatter of what is left, window by
// window.
std::vector<diagnosis::Parameter> numbers_of(const Task& task, const State& fitted);
// Names and values alone.
std::vector<diagnosis::Parameter> values_of(const Task& task, const Model& model);
// Two estimates of one number that differ by more than both allow. That of the rows then carries the noise of the
// motion.
bool contradicts(const diagnosis::Parameter& rows, const diagnosis::Parameter& runs);
// Of a sensor's fault: rows see a delay all over the band, runs beside friction.
bool of_sensor(const diagnosis::Parameter& p);
// Widens the rows' intervals to those of the runs. values_too: the runs' numbers stand, but for those of sensors.
void take_numbers(const std::vector<diagnosis::Parameter>& runs, bool values_too,
                  std::vector<diagnosis::Parameter>& parameters);

// The contract's word and place of a term: "link 1-2", "dof 3", "channel displacement_2_m".
NamedPlace named_place(const Task& task, const Term& term);
// Adds it to the equals of what is named, once.
void list_equal(const NamedPlace& place, Diagnosis& d);

// The rig file with the causes of a model that it can state.
rig_file::RigModel written_rig(const Task& task, const State& fitted);

// A force that is held between its samples is named: found as such, or as a delay of half a sample early.
void name_holds(const Task& task, Diagnosis& d);

// Scores two models on unseen data: the rig as given and that with the causes. `noise`: mean square of each
// channel's. Returns the second's worst NRMSE in percent where a channel shows motion beyond it.
double compare_unseen(const Task& task, const State& base, const State& with_causes, bool any_cause, const Vec& noise,
                      Diagnosis& d);

// A model's free run on unseen data, from the measured state at its start; errors over 1000 % are said as 1000.
struct Score {
  std::vector<double> nrmse_percent, velocity_percent, mse_percent;  // per DOF
  std::vector<double> by_steps_percent;  // per DOF: of nrmse_percent, what the steps of its channel alone make
  double worst_percent = 0;              // of DOFs whose unseen motion its channel shows, beyond those steps
  double by_drives_percent =
      0;  // of that DOF: what another noise of the channels that drive the rig would make of its run
};
Score score_unseen(const Task& task, const State& state, const Vec* noise = nullptr);

}  // namespace diagnosis::runs

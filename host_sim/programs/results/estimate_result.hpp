// What an estimation says, in SI units and words: filled from the core, shown as table and JSON.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "firmware/estimator_core.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/programs/results/warrant_result.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

struct ParameterResult {
  rig_file::ParameterInfo info;
  double value = 0.0, std = 0.0, ci95_low = 0.0, ci95_high = 0.0;
  firmware::EstimateStatus status = firmware::EstimateStatus::kStale;
  std::optional<double> truth;  // simulated rigs
  std::optional<double> paper;  // the paper's own estimate
  // Of a number that is not known, no scatter means that there was none to be had (one window, say), not that it is exact.
  bool has_interval() const {
    return ci95_high > ci95_low ||
           firmware::severity(status) < firmware::severity(firmware::EstimateStatus::kIllConditioned);
  }
};

// How late a channel is against the velocity of its DOF, measured without any model.
struct SkewResult {
  std::string channel;
  double late_us = 0.0, std_us = 0.0;
  bool significant = false;
  bool measured = true;  // else made from other channels of its DOF
};

struct EstimateResult {
  std::vector<ParameterResult> parameters;
  double residual_mean_abs = 0.0;
  std::optional<double> paper_residual;
  double condition_number = 0.0;
  bool inseparable = false;                        // the data cannot tell some of the parameters apart
  bool has_rates = false;                          // every displacement has a velocity or an acceleration beside it
  std::optional<size_t> swings;                    // of the DOF that swings least often, in all records
  bool held = true;                                // springs tie every DOF to the ground: what moves swings
  bool force_known = true;                         // some force is measured, or has its coefficient in the rig file
  bool integrates = false;                         // a velocity or displacement is made from the rates of it alone
  std::vector<std::optional<double>> mse_percent;  // per DOF, Eq. 13; nothing where it cannot be had (see mse_note)
  std::vector<double> paper_mse_percent;
  std::string mse_of;  // what is compared: "acceleration of the free-running simulation"
  std::string mse_note;
  size_t samples = 0;
  double sample_rate_Hz = 0.0;
  unsigned levels = 0, rows = 0;
  // Of the parameters, in their order: the correlation of the least squares with the quoted standard deviations.
  std::vector<std::vector<double>> covariance;
  firmware::CoreHealth health;
  std::vector<SkewResult> skews;
  WarrantResult warrant;
  std::string hum_in;               // channels whose mains hum outdoes the motion in these energies; empty: none
  bool records_contradict = false;  // each other, by coefficients of their own: which, is said in the notes
  std::string advice;               // what to measure next; empty: nothing
  std::string unresolved;           // the combination of parameters that these data show least
  std::vector<std::string> notes;   // for the reader of table and JSON
};

const char* status_word(firmware::EstimateStatus status);  // "VALID"

// Parameters, residual and condition number of the core's estimates, and what to do about them. records: what they were made from.
EstimateResult result_of(const rig_file::RigModel& model, const firmware::Estimates& estimates,
                         const std::vector<Record>& records);
std::vector<double> values_of(const EstimateResult& result);
// EstimateResult::covariance of the core's last solve.
std::vector<std::vector<double>> covariance_of(const EstimateResult& result, const firmware::EstimatorCore& core);

// What to do next: where something is suspected, ask what it is; more data of the same kind help only where nothing is.
std::vector<std::string> next_steps(const EstimateResult& result);

// Empty where every parameter is answered; else why not and what to measure instead. What scatters is noise only where nothing is suspected.
std::string unanswered(const EstimateResult& result);

}  // namespace host_sim

#include "host_sim/programs/results/fit_quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <numeric>

#include "host_sim/force_balance/derivative.hpp"
#include "host_sim/force_balance/force_balance.hpp"
#include "host_sim/plant/motion/fitted_start.hpp"
#include "host_sim/plant/motion/free_run.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "host_sim/records/record_checks.hpp"
#include "host_sim/response/modes.hpp"

namespace host_sim {
namespace {

// Sum of squared differences and of squared deviations from the mean, over records.
struct SquareSums {
  double error = 0.0, deviation = 0.0;

  void add(const Series& measured, const Series& difference) {
    const double mean = std::accumulate(measured.begin(), measured.end(), 0.0) / static_cast<double>(measured.size());
    for (const double value : measured) deviation += (value - mean) * (value - mean);
    for (const double value : difference) error += value * value;
  }
  std::optional<double> percent() const {
    const double ratio = 100.0 * error / deviation;
    return deviation > 0.0 && std::isfinite(ratio) ? std::optional<double>(ratio) : std::nullopt;
  }
};

// The zero of an accelerometer is free: it reads a part of gravity.
void without_mean(Series& y) {
  const double mean = std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
  for (double& value : y) value -= mean;
}

// The acceleration of a DOF by way of the quantity that `like` has of it.
Series acceleration_of(const Record& signals, const Record& like, int dof) {
  const auto values = [&](Quantity quantity) -> const Series* {
    return like.find(quantity, dof) != nullptr ? &signals.find(quantity, dof)->values : nullptr;
  };
  if (const Series* a = values(Quantity::kAcceleration)) return without_margins(*a);
  if (const Series* v = values(Quantity::kVelocity)) return first_derivative(*v, signals.sample_period_s);
  return second_derivative(*values(Quantity::kDisplacement), signals.sample_period_s);
}

bool still(const Channel& channel) {
  const auto [lowest, highest] = std::minmax_element(channel.values.begin(), channel.values.end());
  return channel.quantity == Quantity::kForce && *lowest == *highest;
}

// A free decay is nothing but its initial state, which rates do not tell.
bool begins_unknown(const Record& record) {
  const auto moves_alone = [](const Channel& c) { return !is_drive(c) || still(c); };
  return std::all_of(record.channels.begin(), record.channels.end(), moves_alone) &&
         std::any_of(record.channels.begin(), record.channels.end(), [&](const Channel& c) {
           return !is_drive(c) && record.find(Quantity::kDisplacement, c.dof) == nullptr;
         });
}

// Samples that are too slow to show the rig's slowest mode, which a run from them would go through all the same.
bool too_slow_for(double slowest_Hz, const Record& record) { return 2.0 * record.sample_period_s * slowest_Hz > 1.0; }

std::vector<Record> free_running_error(const rig_file::RigModel& rig, const std::vector<Record>& records,
                                       std::vector<SquareSums>& sums) {
  // Records run beside each other; what they add up to does not depend on which is done first.
  std::vector<std::future<Record>> runs;
  for (const Record& record : records)
    runs.push_back(std::async(std::launch::async, [&rig, &record] { return run_beside(rig, record, {0}); }));
  std::vector<Record> all;
  for (const Record& record : records) {
    Record simulated = runs[all.size()].get();
    for (size_t i = 0; i < sums.size(); ++i) {
      const Series measured = acceleration_of(record, record, static_cast<int>(i + 1));
      Series difference = acceleration_of(simulated, record, static_cast<int>(i + 1));
      for (size_t j = 0; j < difference.size(); ++j) difference[j] -= measured[j];
      if (record.find(Quantity::kAcceleration, static_cast<int>(i + 1)) != nullptr) without_mean(difference);
      sums[i].add(measured, difference);
    }
    all.push_back(std::move(simulated));
  }
  return all;
}

void force_balance_error(const rig_file::RigModel& rig, const std::vector<Record>& records,
                         std::vector<SquareSums>& sums) {
  for (const Record& record : records) {
    const ForceBalance balance = force_balance(rig, record);
    for (size_t i = 0; i < sums.size(); ++i) sums[i].add(balance.reference[i], balance.residual[i]);
  }
}

}  // namespace

std::vector<Record> judge_fit(const rig_file::RigModel& model, const std::vector<Record>& records,
                              EstimateResult& result) {
  std::vector<Record> simulated;
  const rig_file::RigModel rig = rig_file::with_values(model, values_of(result));
  std::vector<SquareSums> sums(model.dofs.size());
  try {
    const double slowest_Hz = runs_freely(rig) ? slowest_mode_Hz(rig) : 0.0;
    result.mse_of = "acceleration, measured against the free-running simulation with the estimates";
    if (result.rows == 0) {
      result.mse_note = "nothing has been estimated to simulate with";
    } else if (runs_freely(rig) && std::any_of(records.begin(), records.end(), begins_unknown)) {
      result.mse_note =
          "velocities and accelerations do not tell the state from which a free decay begins; diagnose fits it and "
          "simulates from there";
    } else if (std::any_of(records.begin(), records.end(),
                           [&](const Record& record) { return too_slow_for(slowest_Hz, record); })) {
      result.mse_note = fmt::format(
          "no simulation: the rig's slowest mode lies at {:.3g} Hz, and samples at {:.3g} Hz cannot show it; are the "
          "times in seconds?",
          slowest_Hz, 1.0 / records.front().sample_period_s);
    } else if (runs_freely(rig)) {
      simulated = free_running_error(rig, records, sums);
    } else {
      result.mse_of = "force balance of each DOF's equation (a rig without a mass above nought cannot run freely)";
      force_balance_error(rig, records, sums);
    }
  } catch (const PlantError& error) {
    result.mse_note = std::string("no simulation with these estimates: ") + error.what();
    sums.assign(sums.size(), SquareSums{});
  }
  result.mse_percent.clear();
  for (const SquareSums& sum : sums) result.mse_percent.push_back(sum.percent());
  return simulated;
}

}  // namespace host_sim

#include "host_sim/reports/views/free_simulation.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/plant/motion/fitted_start.hpp"
#include "host_sim/plant/motion/free_run.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim::reports {
namespace {

// Squared error over variance of the fastest measured quantity of a DOF; 0 where none is measured.
double miss(const Record& record, const Record& simulated, int dof) {
  for (Quantity quantity : {Quantity::kAcceleration, Quantity::kVelocity, Quantity::kDisplacement}) {
    const Channel *a = record.find(quantity, dof), *b = simulated.find(quantity, dof);
    if (a == nullptr || b == nullptr || a->values.empty()) continue;
    double mean = 0.0, error = 0.0, variance = 0.0;
    for (double value : a->values) mean += value / static_cast<double>(a->values.size());
    for (size_t i = 0; i < std::min(a->values.size(), b->values.size()); ++i) {
      error += (a->values[i] - b->values[i]) * (a->values[i] - b->values[i]);
      variance += (a->values[i] - mean) * (a->values[i] - mean);
    }
    return variance > 0.0 ? error / variance : 0.0;
  }
  return 0.0;
}

}  // namespace

std::vector<Record> simulate_all(const rig_file::RigModel& rig, const std::vector<Record>& records,
                                 std::vector<std::string>& notes) {
  if (!runs_freely(rig)) return {};
  try {
    std::vector<Record> out;
    for (const Record& record : records) out.push_back(run_beside(rig, record, {0}));
    return out;
  } catch (const PlantError& error) {
    notes.push_back(std::string("the rig cannot be simulated with these estimates: ") + error.what());
    return {};
  }
}

size_t worst_record(const std::vector<Record>& records, const std::vector<Record>& simulated) {
  size_t worst = 0;
  double most = -1.0;
  for (size_t r = 0; r < std::min(records.size(), simulated.size()); ++r) {
    double sum = 0.0;
    for (const Channel& channel : simulated[r].channels)
      if (channel.quantity == Quantity::kDisplacement) sum += miss(records[r], simulated[r], channel.dof);
    if (sum > most) most = sum, worst = r;
  }
  return worst;
}

}  // namespace host_sim::reports

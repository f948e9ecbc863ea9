// Measured records through the fixed-point core, sample by sample as on the board.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/programs/results/estimate_result.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

struct EstimationOptions {
  // Known period of the excitation: windows are then whole cycles. Without it they are arbitrary intervals (Eq. 12a).
  std::optional<double> excitation_Hz;
  // The frames of a board are wanted: it estimates once a second. Else its core alone is asked, once at the end.
  bool frames = true;
  std::function<void(double)> progress;  // called with the share done, 0 to 1
};

struct Estimation {
  EstimateResult result;
  std::string frames;             // candump log of what the board would have sent, where it is wanted
  std::vector<Record> simulated;  // the rig with the estimates beside each record; empty where it does not run freely
};

// Each record is one level. Throws DataFileError where the records do not fit together, CannotAnswer where they are too
// short. model: has at least one unknown and fits the records' channels.
Estimation estimate_records(const rig_file::RigModel& model, const std::vector<Record>& records,
                            const EstimationOptions& options);

}  // namespace host_sim

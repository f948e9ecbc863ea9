// The core's configuration for recorded samples: windows, filters and resolutions that these records allow.
#pragma once
#include <optional>
#include <vector>

#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// excitation_Hz: windows of whole cycles of it; without it they are arbitrary intervals (Eq. 12a), of a free decay where no record has
// a drive. Throws UsageError where a cycle is shorter than four samples or longer than the record.
firmware::CoreConfiguration configuration_for(const rig_file::RigModel& model, const std::vector<Record>& records,
                                              const std::vector<rig_file::ChannelCalibration>& calibrations,
                                              std::optional<double> excitation_Hz);

}  // namespace host_sim

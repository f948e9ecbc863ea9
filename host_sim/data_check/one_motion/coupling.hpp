// Accelerometers behind a high-pass (piezo, AC input), beside a displacement or a velocity of the same DOF.
//
// The reading y of an acceleration a behind a first-order high-pass obeys y' + wc y = a', wc = 2 pi corner. So averaged under one bell
//   a' = g (y' + late y'' + ... + wc y)
// whatever the rig is, where a' is the third derivative of a displacement or the second of a velocity. Filters that differ are a
// series in derivatives of y; a corner is what goes the other way.
#pragma once
#include <optional>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/data_check.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim::data_check {

struct Corner {
  double corner_Hz = 0.0, std_Hz = 0.0;  // the deviation by leaving out one sixteenth of the record after the other
};
// Nothing where the record is too short, its motion too narrow a band to tell a corner from a delay, or the channels too noisy.
std::optional<Corner> corner_of(const Channel& lower, const Channel& acceleration, double sample_period_s);

// ac_coupling: a corner of more than eight deviations, where the high-pass takes 0.2 % of the channel's rms and more (a damping
// ratio of half of it). A doubt. model: nothing where there is no rig file; what it states is undone already.
// tone_Hz: the highest of the tones that drive the record, 0 where a band does. Where every period is the same, what sampling makes of
// friction's jumps is so too, up to the phase of half a sample, and no part of the record tells it from a corner.
std::vector<Finding> find_ac_coupling(const Record& record, const rig_file::RigModel* model, double tone_Hz = 0.0);

}  // namespace host_sim::data_check

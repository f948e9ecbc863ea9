// Ripple of a force: a line far above all motion, as the cogging of a motor's torque or a switching amplifier leaves it.
#pragma once
#include <optional>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Of a force that acts on a mass (that of a lone damper is its answer, with harmonics of its own). It wanders with the speed, so
// it is looked for in the mean spectrum of 16 parts and more: three times what is around it (chance of one in 10^5), above
// five times the band of every motion channel, with 1 to 20 % of the force's power: less matters to nobody, and what holds
// more is the excitation. value: its frequency, Hz.
std::optional<Finding> find_ripple(const Record& record, const Channel& force, const rig_file::RigModel& model);

// For people, a sentence per force channel over all records of a report.
std::vector<std::string> ripples_of(const Report& report);

}  // namespace host_sim::data_check

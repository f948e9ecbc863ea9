// Channels in words: "displacement of DOF 1", "m".
#pragma once
#include <string>

#include "host_sim/records/record.hpp"

namespace host_sim::reports {

// "force", "torque", "angular velocity", ...
std::string quantity_word(Quantity quantity, bool rotating);
std::string quantity_unit(Quantity quantity, bool rotating);
// "displacement of DOF 1", "displacement of the base"; whether it rotates is taken from the channel's name.
std::string channel_words(const Channel& channel);
bool channel_rotates(const Channel& channel);

}  // namespace host_sim::reports

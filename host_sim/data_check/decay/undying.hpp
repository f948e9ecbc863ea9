// Motion that rises again and again: what drives the rig is not in the recording.
#pragma once
#include <optional>
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Of a record without a force and without a moving base, or of what has been taken for a free decay in it. What a rig loses it does not win
// back: energies of its masses that double again, five times at least, and whose crests do not fall (their mean in the later half is half
// of that in the earlier one or more) are driven. Beats with a mass that is not measured rise again too, each less high. A doubt: a decay
// of more than some hundred swings may hardly fall.
std::optional<Finding> find_undying(const Record& record);

// The crests that rise to twice the trough before them; what is below a twentieth of the largest is no crest.
std::vector<double> crests(const std::vector<double>& energy);

}  // namespace host_sim::data_check

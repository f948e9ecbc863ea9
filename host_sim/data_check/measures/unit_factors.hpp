// Factors by which a channel is off when its numbers are in another unit than its name says.
#pragma once
#include <optional>
#include <string>

#include "host_sim/records/columns/units/units.hpp"

namespace host_sim::data_check {

// The unit of the dimension whose numbers are `factor` times those in SI (mm for 1000), within the tolerance (0.05:
// 5 %). Common units alone; nothing where none fits.
std::optional<std::string> unit_reading(Dimension dimension, double factor, double tolerance);

}  // namespace host_sim::data_check

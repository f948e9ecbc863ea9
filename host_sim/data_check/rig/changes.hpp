// What may be wrong with the channels of a balance: one turned over, or in another unit; all motion in another unit.
#pragma once
#include <string>
#include <vector>

#include "host_sim/data_check/rig/balance.hpp"
#include "host_sim/records/columns/units/units.hpp"

namespace host_sim::data_check {

constexpr double kUnexplained = 0.5;  // of the force (the inertia where there is none), before
constexpr double kExplained = 0.1;    // and after the change
constexpr double kRivals = 2.0;       // the next best change leaves at least this many times more

struct Change {
  std::vector<size_t> channels;  // one, or all motion
  double times = 1.0;            // their values
  std::string unit;              // empty: turned over
  double left = 1.0;
};

Dimension dimension_of_channel(const Channel& channel);

std::vector<Change> changes_of(const std::vector<const Channel*>& channels);

// One factor for each of `count` channels.
std::vector<double> multipliers(size_t count, const Change& change);

// What they say, each with what it leaves unexplained, of which `before` was; nothing where no change stands out.
std::vector<Finding> findings_of(std::vector<Change> changes, const std::vector<const Channel*>& channels,
                                 double before);

}  // namespace host_sim::data_check

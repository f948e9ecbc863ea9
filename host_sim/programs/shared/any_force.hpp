// Whether what drives a rig is measured.
#pragma once
#include <algorithm>

#include "host_sim/records/record_checks.hpp"

namespace host_sim {

inline bool any_force(const Record& record) {
  return std::any_of(record.channels.begin(), record.channels.end(),
                     [](const Channel& c) { return c.quantity == Quantity::kForce && drives(c); });
}
inline bool any_force(const std::vector<Record>& records) {
  return std::any_of(records.begin(), records.end(), [](const Record& record) { return any_force(record); });
}

}  // namespace host_sim

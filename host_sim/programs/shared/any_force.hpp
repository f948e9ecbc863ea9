// Whether what drives a rig is measured.
#pragma once
#include <algorithm>

#include "host_sim/records/record.hpp"

namespace host_sim {

inline bool any_force(const Record& record) {
  return std::any_of(record.channels.begin(), record.channels.end(),
                     [](const Channel& c) { return c.quantity == Quantity::kForce; });
}

}  // namespace host_sim

// Lone channels of two DOFs exchanged: told by the same limits as a turned or foreign one (changes.hpp).
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// h: of the bell (balance.hpp) with which most is explained; before: what is left unexplained as the record stands.
std::vector<Finding> exchanged_dofs(const Record& record, const rig_file::RigModel& model, size_t h, double before);

}  // namespace host_sim::data_check

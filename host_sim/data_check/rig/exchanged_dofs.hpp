// DOFs exchanged, and forces at another DOF than they are said to act on: told by the same limits as a turned or foreign channel
// (changes.hpp).
#pragma once
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Of every two DOFs with the same sensors the motion channels are supposed to be exchanged; of every two, their forces (or the force of the
// one is supposed to act on the other); and both. Nothing is named where one of these cannot be tested: of 180 drawn rigs none is named as
// it stands, and of 460 exchanges none as another (docs/data_check.md). h: of the bell (balance.hpp) with which most is explained; before:
// what is left unexplained as the record stands.
std::vector<Finding> exchanged_dofs(const Record& record, const rig_file::RigModel& model, size_t h, double before);

}  // namespace host_sim::data_check

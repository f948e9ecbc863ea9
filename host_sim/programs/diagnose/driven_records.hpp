// What is put right of driven rigs before they are diagnosed: displacements that count from anywhere, forces that are turned over.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Counts displacements that never come to their zero from where the rig rests, as `estimate` does (rest_position.hpp,
// rest_balance.hpp): a zero that nobody set is no force that the rig file lacks. Training and unseen records alike. Returns what to
// say of each. Not where nothing drives the rig (its middle is free) nor where nothing has a mass: there the motion is imposed, and
// a constant force is measured against it.
std::vector<std::string> count_forced_from_rest(const rig_file::RigModel& rig, std::vector<Record>& training,
                                                std::vector<Record>& unseen);

// Changes the sign of all forces where the core finds that they are turned over (turned_force.hpp). Returns what to say; empty: they
// are not, or nobody can tell.
std::string turn_forces_round(const rig_file::RigModel& rig, std::vector<Record>& training,
                              std::vector<Record>& unseen);

}  // namespace host_sim

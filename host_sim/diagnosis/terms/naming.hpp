// Names, units and places of terms as the contract writes them; the extended rig file.
#pragma once
#include <string>

#include "../diagnosis.hpp"
#include "../rows/model_fit.hpp"

namespace diagnosis {

std::string place_of(const System& system, const Term& term,
                     const FusedRecord& record);  // "link 1-2", "dof 3", "channel ..."
bool rotates(const System& system, const Term& term);
std::string unit_of(Kind kind, bool rotating);
std::string shape_name(Kind kind);  // "end_stop_gap", or empty
std::string shape_unit(Kind kind, bool rotating);
std::string parameter_name(const System& system, const Term& term);  // "viscous[1-0]", "mass[1]"
std::vector<Parameter> parameters_of(const System& system, const std::vector<ActiveTerm>& model);
std::vector<Parameter> parameters_of_term(const System& system, const std::vector<ActiveTerm>& model,
                                          const ActiveTerm& term);

std::string force_channel(const rig_file::RigModel& rig, size_t dof);  // "force_1_N", "torque_1_N_m"
// Delays that were found, added to what a rig file knows of its channels.
void state_delays(const std::vector<Cause>& causes, rig_file::RigModel& rig);

// The rig file with every fitted value as a start, the added terms as effects, links it lacked added.
rig_file::RigModel extended_rig(const System& system, const std::vector<ActiveTerm>& model);

}  // namespace diagnosis

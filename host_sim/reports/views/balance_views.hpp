// What the balance of forces shows: where the energy of a DOF goes, and what each link leaves unexplained.
#pragma once
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/force_balance/force_balance.hpp"
#include "host_sim/reports/data/report_data.hpp"

namespace host_sim::reports {

// Energies since the start by term of the rig as given, and what both rigs leave over. time_s: of the balances' samples.
EnergyBalance energy_balance(const rig_file::RigModel& rig, const ForceBalance& given, const ForceBalance& extended,
                             int dof, const std::vector<double>& time_s, double period_s);

// The force of link `index` that each rig leaves unexplained, and what the extended one has more there.
LinkView link_view(const rig_file::RigModel& given_rig, const rig_file::RigModel& extended_rig, size_t index,
                   const ForceBalance& given, const ForceBalance& extended, const std::vector<double>& time_s);

// The force that this link alone would have to add to make up for the residuals of its ends (least squares).
Series at_link(const rig_file::Link& link, const ForceBalance& balance);

}  // namespace host_sim::reports

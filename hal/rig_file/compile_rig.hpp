// From a rig file in memory to the plain integers that the core runs on.
//
// The unknowns are numbered in file order: for every DOF its mass, then its effects; after all DOFs, for every link its
// stiffness, viscous, Coulomb and gravity coefficients, then its effects. Known coefficients of 0 are left out.
#pragma once
#include <string>
#include <vector>

#include "firmware/configuration/configuration.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/rig_model.hpp"
#include "hal/rig_file/scaled_double.hpp"

namespace rig_file {

// One channel that delivers codes: value in SI units = (code - offset_code) * unit_per_code.
struct ChannelCalibration {
  firmware::Quantity quantity = firmware::Quantity::kDisplacement;
  int dof = 1;  // from 1, or kBase
  double unit_per_code = 1.0;
  int32_t offset_code = 0;
  // The converter's rails: a code at or beyond one of them is a saturated sensor.
  int32_t lowest_code = -firmware::kLargestCode;
  int32_t highest_code = firmware::kLargestCode;
  double delay_s = 0.0;

  // What a channel's entry in the file says of its converter; absent keys leave what is here.
  void take(const ChannelEntry& entry);
};

// Index of a DOF number among the core's nodes: DOF n at n - 1, kBase and kGround at their own places.
int node_index(int dof);

// Signals are planned without knowledge of their ranges (signal_plan.hpp); without channels they are left out.
// The window is left at its default (arbitrary interval); callers that know the excitation's period set it.
// Throws RigFileError where the core's capacity is exceeded, it lacks a term that is to be estimated, or a DOF lacks
// channels.
firmware::CoreConfiguration compile_rig(const RigModel& model, double sample_period_s,
                                        const std::vector<ChannelCalibration>& channels);

struct ParameterInfo {
  std::string name;  // "viscous[1-2]"
  std::string unit;  // "N s/m"
  firmware::TermKind kind = firmware::TermKind::kMass;
  bool dof_term = false;  // of a DOF (mass) rather than of a link
  int place = 0;          // index of the DOF or link in the model
};
// One entry per unknown, in the order of the core's unknowns.
std::vector<ParameterInfo> parameter_table(const RigModel& model);
std::vector<std::string> parameter_names(const RigModel& model);

// The rig with every unknown replaced by values[i], in the order of the core's unknowns: for re-simulation.
RigModel with_values(const RigModel& model, const std::vector<double>& values);

// Words such as "unmodelled_resonance[2]" that only the simulator knows: the core leaves them out.
std::vector<std::string> simulator_only_effects(const RigModel& model);

}  // namespace rig_file

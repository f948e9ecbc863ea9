// Time skew of each DOF's displacement and acceleration against its velocity, without any model of the rig:
//   integral(v x) - change of x^2 / 2 = -tau_x integral(v^2)      x late by tau_x
//   integral(v a) - change of v^2 / 2 = +tau_a integral(a^2)      a late by tau_a
// The left sides are the table's discrepancies; their scatter over the batches gives the standard deviation.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/identification/rows/rows.hpp"

namespace firmware {

// estimates hold the values: how much friction there is tells what a delay is at the least.
void measure_skew(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                  Estimates& estimates);

// How late the channels are at most, s; 0: not at all.
struct Skews {
  Scaled displacement[kMaxDofs], acceleration[kMaxDofs];
};

// Skew is damping: x late by tau adds k tau to the viscous coefficient of the DOF's own stiffness k, a late by tau_a
// takes m tau_a integral(a^2) / integral(v^2) from it. What that bends a coefficient by at the most, in its unit; estimates hold
// the values.
Scaled bend_of_skews(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                     int unknown, const Skews& skews, const Estimates& estimates);

// True where the significant skews bend the coefficient by over twice its standard deviation and over 2 % of it. estimates hold skew,
// values and standard deviations.
bool skew_matters(const EquationList& list, const BatchTable& table, const CoreConfiguration& configuration,
                  int unknown, const Estimates& estimates);

}  // namespace firmware

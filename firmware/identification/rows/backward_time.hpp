// Free motions read from their end.
//
// What is integrated starts from a state that nobody has measured, and a free motion starts with all that it has. It ends at rest: read
// from there, with velocities turned over, the same equations of motion hold with every dissipating force (odd in the rate: m x" + c x'
// + F sgn(x') + k x = 0) of the other sign, and the filters need know nothing. The core estimates such a rig as any other, with dampers
// below nought; these functions turn its numbers over.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/identification/estimate.hpp"

namespace firmware {

// What a coefficient (or a limit of it) is with time as it was: the other sign where time runs back and the term is odd in the rate.
bool turns_over(TermKind kind);
inline Scaled forwards(const CoreConfiguration& configuration, TermKind kind, const Scaled& value) {
  return configuration.runs_back() && turns_over(kind) ? -value : value;
}
bool turns_over(const CoreConfiguration& configuration, int unknown);

// The estimates of levels that ran back as those of the rig: coefficients with their intervals, findings and delays.
void run_forward(const CoreConfiguration& configuration, Estimates& estimates);

}  // namespace firmware

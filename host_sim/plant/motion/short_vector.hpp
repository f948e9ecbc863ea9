// A SUNDIALS vector for the state of a rig: a dozen numbers, of which SUNDIALS' own loops take most of their time to begin.
#pragma once
#include <nvector/nvector_serial.h>

namespace host_sim {

// Replaces the operations that an explicit Runge-Kutta step spends its time in; sums run in the order of SUNDIALS' own
// loops, so results are the same bits. Vectors cloned from this one have them too.
void use_short_loops(N_Vector vector);

}  // namespace host_sim

// Motion that only the filters make.
//
// Where a displacement is integrated its true start is not known: the high-pass of order n forgets it as exp(-t / tau) times a
// polynomial in t, tau = high_pass_shift's time constant. A free decay that is over sooner leaves nothing else in the windows, and
// what follows exp(-t / tau) is what a damper of tau times the stiffness would do: consistent, sure, and wrong. It shows in
// |x v|, which is tau v^2 there or more, and v^2 / w at most of a vibration of w rad/s; what changes x^2 / 2 within a batch is the
// integral of x v, and stands in the table.
#pragma once
#include "firmware/energy/batch_table.hpp"

namespace firmware {

// Whether, in a level, the displacement of a DOF in whose equation the unknown stands is integrated and changes on the mean as slowly
// as that: sum over batches of |x_end^2 - x_start^2| / 2 beyond half of tau times the integral of v^2.
bool filters_alone_move(const BatchTable& table, const CoreConfiguration& configuration, int unknown);

}  // namespace firmware

// Periods of a record's motion: of its slowest part, and of all.
#pragma once
#include "prepared.hpp"

namespace diagnosis::runs {

// Half of what the drift of integrated motion is averaged over, of the DOF that is slowest, s; huge where nothing is integrated.
double slow_s(const Prepared& record);

// Of the guessed motion: 2 pi rms(x) / rms(v), of the DOF that is slowest.
double period_of(const Prepared& record);

}  // namespace diagnosis::runs

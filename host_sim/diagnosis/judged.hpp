// What records say of a rig, as they are.
#pragma once
#include "diagnosis.hpp"
#include "first_screen/rows_say.hpp"

namespace diagnosis {

// The rig as given fitted, causes named one after the other, what is left, what to do about it. lag_s: of all motion channels, that was
// taken out; 0: none.
Diagnosis judged(const Asked& asked, double& lag_s);

}  // namespace diagnosis

// What tests count in the core's answer to a draw.
#pragma once
#include "core_run.hpp"

namespace warrant_test {

// Whether the unknown is VALID, over 5 % and over 4 quoted deviations from the truth.
bool is_valid_and_wrong(const hidden_rig::Draw& draw, const firmware::Estimates& estimates, int unknown);
// Coefficients that are VALID, over 5 % and over 4 quoted deviations from the truth.
int valid_and_wrong(const hidden_rig::Draw& draw, const firmware::Estimates& estimates);
bool suspect(const firmware::Estimates& estimates);  // any MODEL_SUSPECT

}  // namespace warrant_test

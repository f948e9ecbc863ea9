// Numbers that the records do not tell.
#pragma once
#include "answer.hpp"

namespace diagnosis::runs {

// Marks the rig's own numbers, of both models, whose 95 % interval reaches further to either side than all that they are a part of: of a
// viscous or Coulomb coefficient the damping force of its link (|c| w + |F|, w the link's rate, rms), of a mass or a spring itself.
// Says so where there are any.
void mark_undetermined(const Task& task, Diagnosis& d);

}  // namespace diagnosis::runs

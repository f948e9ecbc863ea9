// Numbers that the records do not tell.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Marks the rig's own numbers, of both models, whose 95 % interval reaches further to either side than all that they are a part of, as the
// core does (firmware/identification/conditions/excitation_check.hpp): of a viscous or Coulomb coefficient all that its link dissipates
// (|c| sum of w^2 + |F| sum of |w|, w the link's rate), of a mass or a spring itself. Says so where there are any.
void mark_undetermined(const Task& task, Diagnosis& d);

}  // namespace diagnosis::runs

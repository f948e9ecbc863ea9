// What is said of a choice: the contract's fields.
#pragma once
#include "../choice/choice.hpp"
#include "../diagnosis.hpp"

namespace diagnosis::runs {

// Causes, rivals, both models' parameters, their free runs on unseen data, the extended rig, the remainder and the
// verdict.
void answer(const Task& task, const Choice& choice, Diagnosis& d);

// The rig file with the causes of a model that it can state.
rig_file::RigModel written_rig(const Task& task, const State& fitted);

// A force that is held between its samples is named: found as such, or as a delay of half a sample early.
void name_holds(const Task& task, Diagnosis& d);

}  // namespace diagnosis::runs

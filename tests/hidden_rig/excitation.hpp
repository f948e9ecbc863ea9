// Forces, base motion and initial deflections of one record.
#pragma once
#include "conditions.hpp"
#include "dice.hpp"
#include "integrator.hpp"

namespace hidden_rig {

// What two records of one rig have in common.
struct Shakers {
  std::vector<int> dof;              // driven DOFs
  double level = 1;                  // N
  double low_Hz = 10, high_Hz = 20;  // the two frequencies of sines
  bool soft_hammer = false;          // smooth pulse in place of a half sine
};

Shakers draw_shakers(Dice& dice, const Condition& condition, const TrueRig& rig);

// `samples` and a few more, from rest (or, for free decays, from a deflected shape); substeps that resolve 80 Hz at the
// condition's pace.
Drive draw_drive(Dice& dice, const Condition& condition, const TrueRig& rig, const Shakers& shakers, int record,
                 size_t samples);

}  // namespace hidden_rig

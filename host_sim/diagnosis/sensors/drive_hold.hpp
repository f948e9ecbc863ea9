// How a measured force acts between its samples. A shaker's force is smooth; the output of a converter, and of many a
// simulation, is held until the next sample (steps) or goes there in a straight line. What such a force does above half
// the sampling rate folds back into the sampled motion, where it looks like faults of the sensors.
#pragma once
#include "../record/motion.hpp"

namespace diagnosis {

// Tells the hold from the motion of the driven DOFs (two channels or more), takes what folds back out of their spectra and
// gives the force its mean effect between samples. Wants the noise estimated; sets FusedRecord::hold.
void correct_hold(FusedRecord& record);

// The same for a hold and a mass that are known; the noise is to be estimated and the motion fused anew.
struct KnownHold {
  Hold hold = Hold::kSmooth;
  size_t dof = 0;
  double inverse_mass = 0;
};
void impose_hold(FusedRecord& record, const KnownHold& known);
// Whether correct_hold() could tell how the force on a DOF acts between its samples.
bool tells_hold(const FusedRecord& record, size_t dof);

}  // namespace diagnosis

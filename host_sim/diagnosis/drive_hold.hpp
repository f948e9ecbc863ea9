// How a measured force acts between its samples. A shaker's force is smooth; the output of a converter, and of many a
// simulation, is held until the next sample (steps) or goes there in a straight line. What such a force does above half
// the sampling rate folds back into the sampled motion, where it looks like faults of the sensors.
#pragma once
#include "motion.hpp"

namespace diagnosis {

// Tells the hold from the motion of the driven DOFs (two channels or more), takes what folds back out of their spectra and
// gives the force its mean effect between samples. Wants the noise estimated; sets FusedRecord::hold.
void correct_hold(FusedRecord& record);

}  // namespace diagnosis

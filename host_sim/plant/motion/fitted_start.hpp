// The state in which the motion of a record begins.
#pragma once
#include <vector>

#include "host_sim/plant/motion/free_run.hpp"

namespace host_sim {

// The state that the record shows at one sample (missing velocities from displacement differences, missing displacements 0).
InitialState measured_state(const rig_file::RigModel& rig, const Record& record, size_t sample);

// The state at one sample from which the run meets all measured motion of the next periods (of at most `count` samples) best, each
// channel in shares of its rms: the measured state, moved by least squares, what is measured of it no further than its noise allows. The measured one itself where no other does better by
// more than chance. Throws PlantError where the measured one cannot be run from.
InitialState fitted_start(const FreeRun& run, const rig_file::RigModel& rig, const Record& record, size_t sample,
                          size_t count);

// Displacement, velocity and acceleration of every DOF for all samples of the record, begun anew in a fitted state at each sample of
// `starts` (ascending, the first 0). Throws PlantError.
Record run_beside(const rig_file::RigModel& rig, const Record& record, const std::vector<size_t>& starts);

}  // namespace host_sim

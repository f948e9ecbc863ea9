// The rig's answer to an excitation, sampled. Under what a record measured: free_run.hpp.
#pragma once
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/plant/instruments/signal.hpp"
#include "host_sim/plant/motion/integrator.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

struct InitialState {
  std::vector<double> x_m, v_m_s;  // per DOF; missing entries are 0
};

// Samples at first_sample * period_s .. (first_sample + count - 1) * period_s. The simulation starts at start_sample
// (at or before first_sample; the time between is for settling). t = 0 is the t = 0 of drifting_viscous.
struct SampleTimes {
  double period_s = 1e-3;
  long start_sample = 0;
  long first_sample = 0;
  size_t count = 0;
  double offset_s =
      0.0;  // added to all sample times, not to the start; samples before the start show the initial state
};

// Force, displacement, velocity, acceleration of every DOF, and the base's motion where excitation.base_m is given,
// as channels of a record. Throws PlantError.
Record simulate(const rig_file::RigModel& rig, const InitialState& initial, const Excitation& excitation,
                const SampleTimes& times, const IntegratorOptions& options = {});

}  // namespace host_sim

// The rig's answer to an excitation, sampled: the two ways into the plant.
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

// (a) Force, displacement, velocity, acceleration of every DOF, and the base's motion where excitation.base_m is given,
// as channels of a record. Throws PlantError.
Record simulate(const rig_file::RigModel& rig, const InitialState& initial, const Excitation& excitation,
                const SampleTimes& times, const IntegratorOptions& options = {});

// Options of free_run: measured forces carry noise, so an error far below theirs is enough.
struct FreeRunOptions {
  IntegratorOptions integrator{Method::kSeries, 1e-6, 200000};
  Interpolation interpolation = Interpolation::kQuintic;  // of the record's force and base motion
};

// (b) Simulated displacement, velocity, acceleration of every DOF under the record's measured forces (a DOF without
// force channel has none) and base motion, for samples from .. from + count - 1, started from `initial`.
// drifting_viscous counts its time from the record's first sample. A base channel that is missing is derived from the
// others. Where carried_by_base(), displacement and velocity are against the base, acceleration against the ground.
// Throws PlantError.
Record free_run(const rig_file::RigModel& rig, const Record& record, size_t from, const InitialState& initial,
                size_t count, const FreeRunOptions& options = {});

// Whether every DOF has mass: a rig without does not run.
bool runs_freely(const rig_file::RigModel& rig);

// The state that the record shows at one sample (missing velocities from displacement differences, missing
// displacements 0).
InitialState measured_state(const rig_file::RigModel& rig, const Record& record, size_t sample);

// Contract names: "displacement_1_m", "torque_2_N_m", "velocity_base_m_s".
std::string channel_name(Quantity quantity, int dof, bool rotating);

}  // namespace host_sim

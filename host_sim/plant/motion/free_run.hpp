// A rig beside a record: simulated under what was measured to drive it.
#pragma once
#include <memory>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/plant/motion/simulate.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Options of a free run: measured forces carry noise, so an error far below theirs is enough.
struct FreeRunOptions {
  IntegratorOptions integrator{Method::kSeries, 1e-6, 200000};
  Interpolation interpolation = Interpolation::kQuintic;  // of the record's force and base motion
};

// Simulated displacement, velocity, acceleration of every DOF under the record's measured forces (a DOF without force channel has
// none) and base motion. drifting_viscous counts its time from the record's first sample. A base channel that is missing is derived
// from the others. Where carried_by_base(), displacement and velocity are against the base, acceleration against the ground. Rig and
// record must outlive it.
class FreeRun {
 public:
  FreeRun(const rig_file::RigModel& rig, const Record& record, const FreeRunOptions& options = {});
  // Samples from .. from + count - 1, started from `initial`. Throws PlantError.
  Record samples(size_t from, const InitialState& initial, size_t count) const;

 private:
  const Record& record_;
  rig_file::RigModel rig_;
  FreeRunOptions options_;
  Equations equations_;
  Excitation excitation_;
  const Channel* ridden_ = nullptr;  // the base's acceleration, where the rig is seen from the base
};

// Whether every DOF has mass: a rig without does not run.
bool runs_freely(const rig_file::RigModel& rig);

// One such run.
Record free_run(const rig_file::RigModel& rig, const Record& record, size_t from, const InitialState& initial,
                size_t count, const FreeRunOptions& options = {});

}  // namespace host_sim

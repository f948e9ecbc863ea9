// The columns that a simulation writes, a row at a time.
#pragma once
#include "hal/rig_file/rig_model.hpp"
#include "host_sim/plant/motion/integrator.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

// Displacement, velocity and acceleration of every DOF, and these beside them.
struct MotionColumns {
  bool forces = true;
  bool base = false;
};

// An empty table: one row per sample.
Record motion_record(const rig_file::RigModel& rig, double period_s, double start_s, size_t count,
                     MotionColumns columns);
// What the integrator stands at, as a row of that table.
void store_row(const Integrator& integrator, const Equations& equations, MotionColumns columns, size_t row,
               Record& record);

// Contract names: "displacement_1_m", "torque_2_N_m", "velocity_base_m_s".
std::string channel_name(Quantity quantity, int dof, bool rotating);

bool uses_base(const rig_file::RigModel& rig);

}  // namespace host_sim

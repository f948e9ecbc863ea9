#include "host_sim/plant/motion/free_run.hpp"

#include <algorithm>
#include <string>

#include "host_sim/plant/motion/base_signal.hpp"
#include "host_sim/plant/motion/carried_by_base.hpp"
#include "host_sim/plant/motion/motion_record.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim {
namespace {

Excitation measured_excitation(const rig_file::RigModel& rig, const Record& record, Interpolation interpolation) {
  Excitation excitation;
  const double period_s = record.sample_period_s;
  for (size_t i = 0; i < rig.dofs.size(); ++i) {
    const Channel* force = record.find(Quantity::kForce, static_cast<int>(i + 1));
    excitation.force_N.push_back(force == nullptr ? nullptr : sampled(force->values, 0.0, period_s, interpolation));
  }
  if (uses_base(rig)) excitation.base_m = base_signal(record, 0.0, interpolation);
  return excitation;
}

}  // namespace

FreeRun::FreeRun(const rig_file::RigModel& rig, const Record& record, const FreeRunOptions& options)
    : record_(record),
      rig_(carried_by_base(rig, record) ? seen_from_base(rig) : rig),
      options_(options),
      equations_(rig_) {
  options_.integrator.told_from_s = record.start_s;
  if (carried_by_base(rig, record)) {
    ridden_ = record.find(Quantity::kAcceleration, rig_file::kBase);
    excitation_ = measured_excitation(rig_, with_inertial_forces(rig, record), options.interpolation);
  } else {
    excitation_ = measured_excitation(rig_, record, options.interpolation);
  }
}

Record FreeRun::samples(size_t from, const InitialState& initial, size_t count) const {
  const double period_s = record_.sample_period_s, start_s = static_cast<double>(from) * period_s;
  if (from + count > record_.samples())
    throw PlantError("free run over samples " + std::to_string(from) + " to " + std::to_string(from + count) +
                     ", but the record has " + std::to_string(record_.samples()));
  Record run = motion_record(rig_, period_s, record_.start_s + start_s, count, {false, false});
  const Motion base = excitation_.base_m ? excitation_.base_m->motion(start_s) : Motion{};
  Integrator integrator(equations_, excitation_, options_.integrator, start_s, period_s,
                        equations_.initial_state(initial.x_m, initial.v_m_s, base));
  for (size_t k = 0; k < count; ++k) {
    integrator.advance_to(static_cast<double>(from + k) * period_s);
    store_row(integrator, equations_, {false, false}, k, run);
  }
  if (ridden_ == nullptr) return run;
  for (Channel& c : run.channels)
    for (size_t k = 0; k < count && c.quantity == Quantity::kAcceleration; ++k)
      c.values[k] += ridden_->values[from + k];
  return run;
}

bool runs_freely(const rig_file::RigModel& rig) {
  return std::all_of(rig.dofs.begin(), rig.dofs.end(),
                     [](const rig_file::Dof& dof) { return dof.mass_kg.value > 0.0; });
}

Record free_run(const rig_file::RigModel& rig, const Record& record, size_t from, const InitialState& initial,
                size_t count, const FreeRunOptions& options) {
  return FreeRun(rig, record, options).samples(from, initial, count);
}

}  // namespace host_sim

#include "host_sim/plant/motion/simulate.hpp"

#include "host_sim/plant/motion/motion_record.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim {

Record simulate(const rig_file::RigModel& rig, const InitialState& initial, const Excitation& excitation,
                const SampleTimes& times, const IntegratorOptions& options) {
  const Equations equations(rig);
  if (!excitation.base_m && uses_base(rig)) throw PlantError("the rig has a link to the base, expected a base motion");
  if (times.start_sample > times.first_sample) throw PlantError("start_sample is after first_sample");
  const MotionColumns columns{true, excitation.base_m != nullptr};
  const double h = times.period_s;
  Record record = motion_record(rig, h, static_cast<double>(times.first_sample) * h, times.count, columns);
  const double start_s = static_cast<double>(times.start_sample) * h;
  const Motion base = excitation.base_m ? excitation.base_m->motion(start_s) : Motion{};
  Integrator integrator(equations, excitation, options, start_s, h,
                        equations.initial_state(initial.x_m, initial.v_m_s, base));
  for (long k = times.start_sample; k < times.first_sample + static_cast<long>(times.count); ++k) {
    integrator.advance_to(static_cast<double>(k) * h + times.offset_s);
    if (k >= times.first_sample)
      store_row(integrator, equations, columns, static_cast<size_t>(k - times.first_sample), record);
  }
  return record;
}

}  // namespace host_sim

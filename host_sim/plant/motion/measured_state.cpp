#include "host_sim/plant/instruments/signal.hpp"
#include "host_sim/plant/motion/fitted_start.hpp"

namespace host_sim {

InitialState measured_state(const rig_file::RigModel& rig, const Record& record, size_t sample) {
  InitialState state;
  for (size_t i = 0; i < rig.dofs.size(); ++i) {
    const Channel* x = record.find(Quantity::kDisplacement, static_cast<int>(i + 1));
    const Channel* v = record.find(Quantity::kVelocity, static_cast<int>(i + 1));
    state.x_m.push_back(x == nullptr ? 0.0 : x->values.at(sample));
    double rate = 0.0;
    if (v != nullptr)
      rate = v->values.at(sample);
    else if (x != nullptr)
      rate = sampled(x->values, 0.0, record.sample_period_s)
                 ->motion(static_cast<double>(sample) * record.sample_period_s)
                 .rate;
    state.v_m_s.push_back(rate);
  }
  return state;
}

}  // namespace host_sim

#include "host_sim/plant/motion/simulate.hpp"

#include <algorithm>
#include <cmath>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/plant/motion/carried_by_base.hpp"
#include "host_sim/plant/plant_error.hpp"

namespace host_sim {
namespace {

Channel& add_channel(Record& record, Quantity quantity, int dof, bool rotating, size_t count) {
  record.channels.push_back({channel_name(quantity, dof, rotating), quantity, dof, std::vector<double>(count)});
  return record.channels.back();
}

struct Output {
  bool forces = true;
  bool base = false;
};

// One row of the record per sample: columns in the order in which make_record adds them.
Record make_record(const rig_file::RigModel& rig, double period_s, double start_s, size_t count, Output output) {
  Record record;
  record.sample_period_s = period_s;
  record.start_s = start_s;
  for (size_t i = 0; i < rig.dofs.size(); ++i) {
    const int dof = static_cast<int>(i + 1);
    const bool rotating = rig.dofs[i].rotating;
    if (output.forces) add_channel(record, Quantity::kForce, dof, rotating, count);
    for (Quantity q : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      add_channel(record, q, dof, rotating, count);
  }
  const bool rotating = !rig.dofs.empty() && rig.dofs[0].rotating;
  if (output.base)
    for (Quantity q : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
      add_channel(record, q, rig_file::kBase, rotating, count);
  return record;
}

void store(const Integrator& integrator, const Equations& equations, Output output, size_t row, Record& record) {
  const std::vector<double>& y = integrator.state();
  const std::vector<double>& dy = integrator.derivative();
  size_t column = 0;
  const auto put = [&](double value) { record.channels[column++].values[row] = value; };
  for (size_t i = 0; i < equations.masses(); ++i) {
    if (output.forces) put(integrator.forces()[i]);
    put(y[i]);
    put(y[equations.masses() + i]);
    put(dy[equations.masses() + i]);
  }
  if (!output.base) return;
  put(integrator.base().value);
  put(integrator.base().rate);
  put(integrator.base().acceleration);
}

bool uses_base(const rig_file::RigModel& rig) {
  for (const rig_file::Link& link : rig.links)
    if (link.a == rig_file::kBase || link.b == rig_file::kBase) return true;
  return false;
}

std::vector<double> integrated(const std::vector<double>& rate, double h) {
  std::vector<double> sum(rate.size(), 0.0);
  for (size_t k = 1; k < rate.size(); ++k) sum[k] = sum[k - 1] + 0.5 * h * (rate[k] + rate[k - 1]);
  return sum;
}

SignalPtr base_signal(const Record& record, double start_s, Interpolation interpolation) {
  const Channel* x = record.find(Quantity::kDisplacement, rig_file::kBase);
  if (x != nullptr) return sampled(x->values, start_s, record.sample_period_s, interpolation);
  const Channel* v = record.find(Quantity::kVelocity, rig_file::kBase);
  if (v != nullptr)
    return sampled(integrated(v->values, record.sample_period_s), start_s, record.sample_period_s, interpolation);
  throw PlantError(
      "the rig has a link to the base, but the record has no channel displacement_base_m or velocity_base_m_s");
}

}  // namespace

std::string channel_name(Quantity quantity, int dof, bool rotating) {
  return rig_file::format_channel_name({static_cast<firmware::Quantity>(quantity), dof, rotating});
}

Record simulate(const rig_file::RigModel& rig, const InitialState& initial, const Excitation& excitation,
                const SampleTimes& times, const IntegratorOptions& options) {
  const Equations equations(rig);
  if (!excitation.base_m && uses_base(rig)) throw PlantError("the rig has a link to the base, expected a base motion");
  if (times.start_sample > times.first_sample) throw PlantError("start_sample is after first_sample");
  const Output output{true, excitation.base_m != nullptr};
  const double h = times.period_s;
  Record record = make_record(rig, h, static_cast<double>(times.first_sample) * h, times.count, output);
  const double start_s = static_cast<double>(times.start_sample) * h;
  const Motion base = excitation.base_m ? excitation.base_m->motion(start_s) : Motion{};
  Integrator integrator(equations, excitation, options, start_s, h,
                        equations.initial_state(initial.x_m, initial.v_m_s, base));
  for (long k = times.start_sample; k < times.first_sample + static_cast<long>(times.count); ++k) {
    integrator.advance_to(static_cast<double>(k) * h + times.offset_s);
    if (k >= times.first_sample)
      store(integrator, equations, output, static_cast<size_t>(k - times.first_sample), record);
  }
  return record;
}

bool runs_freely(const rig_file::RigModel& rig) {
  return std::all_of(rig.dofs.begin(), rig.dofs.end(),
                     [](const rig_file::Dof& dof) { return dof.mass_kg.value > 0.0; });
}

Record free_run(const rig_file::RigModel& rig, const Record& record, size_t from, const InitialState& initial,
                size_t count, const FreeRunOptions& options) {
  if (carried_by_base(rig, record)) {
    Record run = free_run(seen_from_base(rig), with_inertial_forces(rig, record), from, initial, count, options);
    const std::vector<double>& base = record.find(Quantity::kAcceleration, rig_file::kBase)->values;
    for (Channel& c : run.channels)
      for (size_t k = 0; k < count && c.quantity == Quantity::kAcceleration; ++k) c.values[k] += base[from + k];
    run.start_s = record.start_s + static_cast<double>(from) * record.sample_period_s;
    return run;
  }
  const Equations equations(rig);
  const double h = record.sample_period_s;
  if (from + count > record.samples())
    throw PlantError("free run over samples " + std::to_string(from) + " to " + std::to_string(from + count) +
                     ", but the record has " + std::to_string(record.samples()));
  Excitation excitation;
  for (size_t i = 0; i < rig.dofs.size(); ++i) {
    const Channel* force = record.find(Quantity::kForce, static_cast<int>(i + 1));
    excitation.force_N.push_back(force == nullptr ? nullptr : sampled(force->values, 0.0, h, options.interpolation));
  }
  if (uses_base(rig)) excitation.base_m = base_signal(record, 0.0, options.interpolation);
  Record result = make_record(rig, h, record.start_s + static_cast<double>(from) * h, count, {false, false});
  const double start_s = static_cast<double>(from) * h;
  const Motion base = excitation.base_m ? excitation.base_m->motion(start_s) : Motion{};
  IntegratorOptions integrator_options = options.integrator;
  integrator_options.told_from_s = record.start_s;
  Integrator integrator(equations, excitation, integrator_options, start_s, h,
                        equations.initial_state(initial.x_m, initial.v_m_s, base));
  for (size_t k = 0; k < count; ++k) {
    integrator.advance_to(static_cast<double>(from + k) * h);
    store(integrator, equations, {false, false}, k, result);
  }
  return result;
}

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

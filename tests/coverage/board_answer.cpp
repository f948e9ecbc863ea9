#include "board_answer.hpp"

#include <memory>

#include "firmware/estimator_core.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "host_sim/records/digitise.hpp"

namespace coverage {

Answer answer_to(const rig_file::RigModel& rig, const std::vector<host_sim::Record>& records) {
  const auto calibrations = host_sim::calibrate(records, rig);
  firmware::CoreConfiguration configuration = rig_file::compile_rig(rig, records.front().sample_period_s, calibrations);
  std::vector<std::vector<firmware::RawSample>> samples;
  bool force = false;
  for (const host_sim::Channel& c : records.front().channels)
    force = force || c.quantity == host_sim::Quantity::kForce || c.dof == rig_file::kBase;
  for (const host_sim::Record& record : records) {
    host_sim::RecordSampleSource source(record, calibrations);
    samples.emplace_back(record.samples());
    for (firmware::RawSample& sample : samples.back()) source.read(sample);
  }
  rig_file::plan_signals(configuration, rig_file::measure_ranges(configuration, samples));
  configuration.window.mode = force ? firmware::WindowMode::kInterval : firmware::WindowMode::kFreeDecay;
  const auto core = std::make_unique<firmware::EstimatorCore>(configuration);
  uint32_t sequence = 0;
  for (const auto& record : samples) {
    core->begin_level();
    for (firmware::RawSample sample : record) {
      sample.sequence = sequence++;
      core->push(sample);
    }
    core->end_level();
  }
  return {core->solve(), rig_file::parameter_names(rig)};
}

}  // namespace coverage

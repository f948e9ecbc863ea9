#include "core_run.hpp"

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "host_sim/records/digitise.hpp"

namespace warrant_test {

CoreRun run_core(const hidden_rig::Draw& draw, uint16_t budget) {
  CoreRun run;
  const auto calibrations = host_sim::calibrate(draw.records, draw.rig);
  run.configuration = rig_file::compile_rig(draw.rig, draw.records.front().sample_period_s, calibrations);
  std::vector<std::vector<firmware::RawSample>> samples;
  for (const host_sim::Record& record : draw.records) {
    host_sim::RecordSampleSource source(record, calibrations);
    samples.emplace_back(record.samples());
    for (firmware::RawSample& sample : samples.back()) source.read(sample);
  }
  rig_file::plan_signals(run.configuration,
                         rig_file::measure_ranges(run.configuration, samples, rig_file::Corner::kBelowMotion));
  bool force = false;
  for (const host_sim::Channel& c : draw.records.front().channels)
    force = force || c.quantity == host_sim::Quantity::kForce || c.dof == rig_file::kBase;
  run.configuration.window.mode = force ? firmware::WindowMode::kInterval : firmware::WindowMode::kFreeDecay;
  run.configuration.probe_products_per_sample = budget;
  run.core = std::make_unique<firmware::EstimatorCore>(run.configuration);
  uint32_t sequence = 0;
  for (const auto& record : samples) {
    run.core->begin_level();
    for (firmware::RawSample sample : record) {
      sample.sequence = sequence++;
      run.core->push(sample);
    }
    run.core->end_level();
  }
  run.core->solve();
  return run;
}

}  // namespace warrant_test

#include "host_sim/virtual_rig/run_scenario.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "firmware/conditioning/conditioning.hpp"
#include "hal/rig_file/channel_entry.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/first_batches.hpp"
#include "hal/rig_file/signal_plan.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "host_sim/virtual_rig/board_configuration.hpp"
#include "host_sim/virtual_rig/level_feed.hpp"
#include "host_sim/virtual_rig/resimulation.hpp"

namespace host_sim {
namespace {

// Signals that must be derived get the resolution that the measured levels allow.
void fit_derived_signals(const MeasuredLevels& levels, firmware::CoreConfiguration& configuration) {
  if (rig_file::describe_plan(configuration).empty()) return;
  std::vector<std::vector<firmware::RawSample>> samples;
  for (const Record& record : levels.measured) {
    RecordSampleSource source(record, levels.calibrations);
    samples.emplace_back(record.samples());
    for (firmware::RawSample& sample : samples.back()) source.read(sample);
  }
  rig_file::plan_signals(configuration, rig_file::measure_ranges(configuration, samples));
}

void fill_parameters(const Scenario& scenario, const firmware::Estimates& estimates, RunResult& result) {
  const std::vector<rig_file::ParameterInfo> table = rig_file::parameter_table(scenario.rig);
  for (size_t i = 0; i < table.size(); ++i) {
    const firmware::ParameterEstimate& estimate = estimates.parameters[i];
    RunParameter parameter;
    parameter.info = table[i];
    parameter.truth = scenario.truth[i];
    parameter.value = rig_file::to_double(estimate.value);
    parameter.std = rig_file::to_double(estimate.std);
    parameter.ci95_low = rig_file::to_double(estimate.ci95_low);
    parameter.ci95_high = rig_file::to_double(estimate.ci95_high);
    parameter.status = estimate.status;
    result.parameters.push_back(parameter);
  }
  result.residual_mean_abs = rig_file::to_double(estimates.residual_mean_abs);
  result.condition_number = rig_file::to_double(estimates.condition_number);
  result.rows = estimates.rows;
  result.estimates = estimates;
}

// The core's window is shorter than what it is given by its filters' margin; what settling does not provide is sampled
// beyond the level's end. The margin follows from which channels there are, not from their ranges.
Scenario with_room_for_filters(const Scenario& scenario) {
  std::vector<rig_file::ChannelCalibration> calibrations;
  for (const Channel& channel : measured_channels(scenario)) {
    calibrations.emplace_back();
    calibrations.back().quantity = static_cast<firmware::Quantity>(channel.quantity);
    calibrations.back().dof = channel.dof;
    calibrations.back().delay_s = rig_file::stated_delay_s(scenario.rig, channel.name);
  }
  const firmware::CoreConfiguration configuration =
      rig_file::compile_rig(scenario.rig, scenario.sample_period_s(), calibrations);
  const auto filters = std::make_unique<firmware::Conditioning>();  // a whole core takes longer to make than to ask
  filters->configure(configuration);
  const auto margin = static_cast<size_t>(filters->margin_samples());
  Scenario result = scenario;
  for (ExcitationLevel& level : result.levels)
    level.run_out_samples = std::max(kRunOutSamples, margin - std::min(margin, level.settle_samples));
  return result;
}

}  // namespace

firmware::WindowConfiguration scenario_window(const Scenario& scenario) {
  firmware::WindowConfiguration window;
  const std::vector<ExcitationLevel>& levels = scenario.levels;
  const bool all_free = std::all_of(levels.begin(), levels.end(),
                                    [](const ExcitationLevel& l) { return l.kind == LevelKind::kFreeDecay; });
  window.mode = all_free ? firmware::WindowMode::kFreeDecay : firmware::WindowMode::kInterval;
  uint64_t common = 1;
  size_t shortest = levels.front().samples;
  for (const ExcitationLevel& level : levels) shortest = std::min(shortest, level.samples);
  window.batch_samples = rig_file::first_batch_samples(shortest);
  for (const ExcitationLevel& level : levels) {
    if (!level.periodic()) return window;
    const double cycle = scenario.sample_rate_Hz / level.frequency_Hz;
    const double whole = std::nearbyint(cycle);
    if (whole < 4.0 || std::fabs(cycle - whole) > 1e-9 * cycle) return window;
    common = std::lcm(common, static_cast<uint64_t>(whole));
    if (level.samples % static_cast<uint64_t>(whole) != 0) return window;
    if (common > shortest) return window;
  }
  window.mode = firmware::WindowMode::kWholeCycles;
  window.batch_samples = 0;
  window.cycle_samples_numerator = static_cast<uint32_t>(common);
  window.cycle_samples_denominator = 1;
  return window;
}

RunResult run_scenario(const Scenario& scenario, uint64_t seed, ProgressSink& sink) {
  VirtualRig rig(with_room_for_filters(scenario), seed);
  firmware::CoreConfiguration configuration =
      rig_file::compile_rig(scenario.rig, scenario.sample_period_s(), rig.measured().calibrations);
  configuration.window = scenario_window(scenario);
  fit_derived_signals(rig.measured(), configuration);
  ReplayBoard board(board_configuration(scenario.rig, configuration, scenario.sample_period_s()),
                    [&sink](const hal::CanFrame& frame) { sink.frame(frame); });
  sink.begin(scenario, configuration);
  LevelFeed feed(rig, board, sink);
  feed.run();
  const firmware::Estimates& estimates = *board.controller().estimates();
  sink.progress(1.0);
  sink.window(rig.now_ns(), estimates, board.core().health(), true);
  RunResult result;
  fill_parameters(scenario, estimates, result);
  result.samples = feed.pushed();
  result.sample_rate_Hz = scenario.sample_rate_Hz;
  result.health = board.core().health();
  result.measured = rig.take_measured();
  judge_by_resimulation(rig.scenario(), result);
  return result;
}

}  // namespace host_sim

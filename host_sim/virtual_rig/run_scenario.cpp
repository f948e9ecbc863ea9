#include "host_sim/virtual_rig/run_scenario.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "hal/configuration/compile_rig.hpp"
#include "hal/configuration/signal_plan.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "host_sim/plant/shaker.hpp"

namespace host_sim {
namespace {

constexpr uint64_t kTick_ns = 100000000, kWindow_ns = 1000000000;

// Reads the virtual rig to its end; what is measured goes into the core, with the margin that its window needs.
class Feed {
 public:
  Feed(VirtualRig& rig, firmware::EstimatorCore& core, ProgressSink& sink) : rig_(rig), core_(core), sink_(sink) {}

  void run() {
    firmware::RawSample sample;
    uint64_t last_ns = 0;
    while (rig_.read(sample) == hal::SampleResult::kSample) {
      if (rig_.first_of_level()) begin_level();
      const bool wanted = rig_.phase() != RigPhase::kSettling && in_level_ < most_;
      if (wanted) push(sample);
      const uint64_t now_ns = rig_.now_ns();
      if (now_ns / kTick_ns != last_ns / kTick_ns) tell(now_ns, wanted && now_ns / kWindow_ns != last_ns / kWindow_ns);
      last_ns = now_ns;
      if (rig_.last_of_level()) {
        core_.end_level();
        sink_.window(now_ns, core_.solve(), core_.health(), false);
      }
    }
    core_.end_level();
  }
  size_t pushed() const { return pushed_; }

 private:
  void begin_level() {
    core_.begin_level();
    in_level_ = 0;
    most_ = rig_.scenario().levels[rig_.level()].samples + static_cast<size_t>(core_.margin_samples());
  }
  void push(firmware::RawSample& sample) {
    sample.sequence = static_cast<uint32_t>(pushed_++);  // what is left out between levels is not missed
    core_.push(sample);
    ++in_level_;
  }
  void tell(uint64_t now_ns, bool window) {
    sink_.tick(now_ns);
    sink_.progress(static_cast<double>(sample_count()) / static_cast<double>(rig_.total_samples()));
    if (window) sink_.window(now_ns, core_.solve(), core_.health(), false);
  }
  size_t sample_count() const {
    return static_cast<size_t>(
        std::llround(static_cast<double>(rig_.now_ns()) * 1e-9 * rig_.scenario().sample_rate_Hz));
  }

  VirtualRig& rig_;
  firmware::EstimatorCore& core_;
  ProgressSink& sink_;
  size_t in_level_ = 0, most_ = 0, pushed_ = 0;
};

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

Scenario with_estimates(const Scenario& scenario, const RunResult& result) {
  std::vector<double> values;
  for (const RunParameter& parameter : result.parameters) values.push_back(parameter.value);
  Scenario estimated = scenario;
  estimated.plant = rig_file::with_values(scenario.rig, values);
  return estimated;
}

// Eq. 13 of one DOF over the measured part of all levels: N sigma^2 is the sum of squared deviations from each level's
// mean.
double mean_square_error(const Scenario& scenario, const RunResult& result, int dof) {
  const std::vector<Record>& truth = result.measured.truth;
  double error = 0.0, deviation = 0.0;
  for (size_t level = 0; level < truth.size(); ++level) {
    const size_t from = scenario.levels[level].settle_samples, count = scenario.levels[level].samples;
    const double* a = truth[level].find(Quantity::kAcceleration, dof)->values.data() + from;
    const double* b = result.resimulated[level].find(Quantity::kAcceleration, dof)->values.data() + from;
    const double mean = std::accumulate(a, a + count, 0.0) / static_cast<double>(count);
    for (size_t k = 0; k < count; ++k) {
      error += (a[k] - b[k]) * (a[k] - b[k]);
      deviation += (a[k] - mean) * (a[k] - mean);
    }
  }
  return deviation > 0.0 ? 100.0 * error / deviation : std::numeric_limits<double>::quiet_NaN();
}

void resimulate(const Scenario& scenario, uint64_t seed, RunResult& result) {
  result.mse_percent.assign(scenario.rig.dofs.size(), std::numeric_limits<double>::quiet_NaN());
  try {
    const Scenario estimated = with_estimates(scenario, result);
    for (size_t level = 0; level < scenario.levels.size(); ++level)
      result.resimulated.push_back(simulate_level(estimated, level, seed));
    for (size_t i = 0; i < result.mse_percent.size(); ++i)
      result.mse_percent[i] = mean_square_error(scenario, result, static_cast<int>(i + 1));
  } catch (const PlantError& error) {
    result.mse_note = std::string("the rig with the estimates cannot be simulated: ") + error.what();
    result.resimulated.clear();
  }
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
  for (const ExcitationLevel& level : levels) {
    if (!level.periodic()) return window;
    const double cycle = scenario.sample_rate_Hz / level.frequency_Hz;
    const double whole = std::nearbyint(cycle);
    if (whole < 4.0 || std::fabs(cycle - whole) > 1e-9 * cycle) return window;
    common = std::lcm(common, static_cast<uint64_t>(whole));
    if (level.samples % static_cast<uint64_t>(whole) != 0) return window;
    shortest = std::min(shortest, level.samples);
    if (common > shortest) return window;
  }
  window.mode = firmware::WindowMode::kWholeCycles;
  window.cycle_samples_numerator = static_cast<uint32_t>(common);
  window.cycle_samples_denominator = 1;
  return window;
}

RunResult run_scenario(const Scenario& scenario, uint64_t seed, ProgressSink& sink) {
  VirtualRig rig(scenario, seed);
  firmware::CoreConfiguration configuration =
      rig_file::compile_rig(scenario.rig, scenario.sample_period_s(), rig.measured().calibrations);
  configuration.window = scenario_window(scenario);
  fit_derived_signals(rig.measured(), configuration);
  const auto core = std::make_unique<firmware::EstimatorCore>(configuration);
  if (static_cast<size_t>(core->margin_samples()) > kRunOutSamples)
    throw PlantError("the core's filters need " + std::to_string(core->margin_samples()) +
                     " samples beyond a level, the simulation gives " + std::to_string(kRunOutSamples));
  sink.begin(scenario, configuration);
  Feed feed(rig, *core, sink);
  feed.run();
  const firmware::Estimates& estimates = core->solve();
  sink.progress(1.0);
  sink.window(rig.now_ns(), estimates, core->health(), true);
  RunResult result;
  fill_parameters(scenario, estimates, result);
  result.samples = feed.pushed();
  result.sample_rate_Hz = scenario.sample_rate_Hz;
  result.health = core->health();
  result.measured = rig.measured();
  resimulate(scenario, seed, result);
  return result;
}

}  // namespace host_sim

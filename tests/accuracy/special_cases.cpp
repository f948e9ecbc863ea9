#include "tests/accuracy/special_cases.hpp"

#include <algorithm>
#include <cmath>

#include "tests/accuracy/cases.hpp"
#include "tests/accuracy/redraw.hpp"
#include "tests/accuracy/skew_bound.hpp"

namespace accuracy {
namespace {

using firmware::EstimateStatus;

double error_percent(const firmware::Estimates& estimates, const host_sim::Scenario& scenario, size_t k) {
  return 100.0 * (rig_file::to_double(estimates.parameters[k].value) / scenario.truth[k] - 1.0);
}

host_sim::Scenario late_displacement(double delay_us, double compensation_us) {
  host_sim::Scenario scenario = with_noise("paper_3dof_random", 5.0);
  for (host_sim::ExcitationLevel& level : scenario.levels) level.samples = 10000;
  for (int dof = 1; dof <= 3; ++dof) {
    const std::string name = "displacement_" + std::to_string(dof) + "_m";
    scenario.sensors.channel[name] = scenario.sensors.every;
    scenario.sensors.channel[name].delay_us = delay_us;
    if (compensation_us == 0.0) continue;
    rig_file::ChannelEntry entry;
    entry.name = name;
    entry.delay_us = compensation_us;
    scenario.rig.channels.push_back(entry);
  }
  return scenario;
}

std::vector<double> mean_errors(const host_sim::Scenario& scenario, int draws) {
  Redraw redraw(scenario);
  std::vector<double> mean(scenario.truth.size(), 0.0);
  for (int d = 0; d < draws; ++d) {
    const firmware::Estimates& estimates = redraw.run(static_cast<uint64_t>(d + 1));
    for (size_t k = 0; k < mean.size(); ++k) mean[k] += error_percent(estimates, scenario, k) / draws;
  }
  return mean;
}

SensorSet measure_set(const std::string& name, host_sim::Quantity quantity, int draws) {
  host_sim::Scenario scenario = with_noise("paper_3dof_random", 0.1);
  scenario.sensors.quantities = {host_sim::Quantity::kForce, quantity};
  Redraw redraw(scenario);
  SensorSet set;
  set.name = name;
  for (int d = 0; d < draws; ++d) {
    const firmware::Estimates& estimates = redraw.run(static_cast<uint64_t>(d + 1));
    bool valid = true;
    for (size_t k = 0; k < scenario.truth.size(); ++k) {
      double& worst = k < 4 ? set.worst_viscous_percent : set.worst_coulomb_percent;
      worst = std::max(worst, std::fabs(error_percent(estimates, scenario, k)));
      valid = valid && estimates.parameters[k].status == EstimateStatus::kValid;
    }
    if (!valid) ++set.not_valid;
  }
  return set;
}

}  // namespace

SkewMeasurement measure_skew(int draws) {
  constexpr double kDelay_us = 250.0;
  const host_sim::Scenario scenario = late_displacement(kDelay_us, 0.0);
  Redraw redraw(scenario);
  SkewMeasurement result;
  std::vector<double> sum(3, 0.0), square(3, 0.0);
  result.error_before_percent.assign(scenario.truth.size(), 0.0);
  redraw.run(0, false);
  for (int dof = 1; dof <= 3; ++dof) result.bound_us.push_back(1e6 * skew_bound_s(redraw.records(), dof, 5.0));
  for (int d = 0; d < draws; ++d) {
    const firmware::Estimates& estimates = redraw.run(static_cast<uint64_t>(d + 1));
    bool marked = false;
    for (size_t k = 0; k < scenario.truth.size(); ++k) {
      result.error_before_percent[k] += error_percent(estimates, scenario, k) / draws;
      marked = marked || estimates.parameters[k].status == EstimateStatus::kSkewed;
    }
    result.marked_percent += marked ? 100.0 / draws : 0.0;
    for (size_t i = 0; i < 3; ++i) {
      const double late_us = 1e6 * rig_file::to_double(estimates.displacement_skew[i].late_s);
      sum[i] += late_us / draws;
      square[i] += late_us * late_us / draws;
      if (std::fabs(late_us - kDelay_us) <= 15.0) result.within_15_us_percent += 100.0 / (3.0 * draws);
    }
  }
  double mean_us = 0.0;
  for (size_t i = 0; i < 3; ++i) {
    result.mean_us.push_back(sum[i]);
    result.deviation_us.push_back(std::sqrt(std::max(0.0, square[i] - sum[i] * sum[i])));
    mean_us += sum[i] / 3.0;
  }
  result.error_after_percent = mean_errors(late_displacement(kDelay_us, mean_us), draws);
  return result;
}

std::vector<SensorSet> measure_sensor_sets(int draws) {
  return {measure_set("displacement", host_sim::Quantity::kDisplacement, draws),
          measure_set("velocity", host_sim::Quantity::kVelocity, draws),
          measure_set("acceleration", host_sim::Quantity::kAcceleration, draws)};
}

FollowedAdvice follow_advice(int draws) {
  FollowedAdvice result;
  host_sim::Scenario scenario = with_noise("paper_3dof_one_frequency", 0.0);
  {
    Redraw redraw(scenario);
    const firmware::Estimates& estimates = redraw.run(0, false);
    for (size_t k = 0; k < scenario.truth.size(); ++k)
      if (estimates.parameters[k].status == EstimateStatus::kIllConditioned) ++result.ill_conditioned_clean;
    if (estimates.advice == firmware::Advice::kAddFrequency)
      result.advised_Hz = rig_file::to_double(estimates.advice_frequency_Hz);
  }
  {
    Redraw redraw(with_noise("paper_3dof_one_frequency", 5.0));
    for (result.draws = 0; result.draws < draws; ++result.draws)
      if (redraw.run(static_cast<uint64_t>(result.draws + 1)).parameters[0].status == EstimateStatus::kIllConditioned)
        ++result.ill_conditioned_noisy;
  }
  if (result.advised_Hz <= 0.0) return result;
  // "Near" the advised frequency: the nearest whose cycle is a whole number of samples.
  host_sim::ExcitationLevel& level = scenario.levels[1];
  const double cycle = std::round(scenario.sample_rate_Hz / result.advised_Hz);
  level.frequency_Hz = scenario.sample_rate_Hz / cycle;
  level.samples = static_cast<size_t>(cycle * std::floor(20000.0 / cycle));
  level.settle_samples = static_cast<size_t>(cycle * std::ceil(6000.0 / cycle));
  Redraw redraw(scenario);
  const firmware::Estimates& estimates = redraw.run(0, false);
  for (size_t k = 0; k < scenario.truth.size(); ++k) {
    result.error_after_percent = std::max(result.error_after_percent, std::fabs(error_percent(estimates, scenario, k)));
    if (estimates.parameters[k].status == EstimateStatus::kValid) ++result.valid_after;
  }
  return result;
}

}  // namespace accuracy

#include "host_sim/plant/instruments/shaker.hpp"

#include <algorithm>

namespace host_sim {

Excitation level_excitation(const Scenario& scenario, size_t level_number, uint64_t seed) {
  const ExcitationLevel& level = scenario.levels[level_number];
  const double h = scenario.sample_period_s();
  Excitation excitation;
  excitation.force_N.resize(scenario.plant.dofs.size());
  const size_t driven = static_cast<size_t>(level.dof - 1);
  const double settle_s = static_cast<double>(level.settle_samples) * h;
  switch (level.kind) {
    case LevelKind::kSine:
      excitation.force_N[driven] = cosine(level.amplitude, level.frequency_Hz);
      break;
    case LevelKind::kBaseSine:
      excitation.base_m = cosine(level.amplitude, level.frequency_Hz);
      break;
    case LevelKind::kRandom:
      excitation.force_N[driven] = random_band({level.rms_N, level.low_Hz, level.high_Hz}, -settle_s,
                                               static_cast<double>(level.samples + 1 + level.run_out_samples) * h,
                                               std::min(h, 0.05 / level.high_Hz), seed, level_number);
      break;
    case LevelKind::kFreeDecay:
      break;
  }
  for (const rig_file::Link& link : scenario.plant.links)
    if (link.b == rig_file::kBase && !excitation.base_m) excitation.base_m = cosine(0.0, 0.0);
  return excitation;
}

Record simulate_level(const Scenario& scenario, size_t level_number, const Excitation& excitation, double offset_s) {
  const ExcitationLevel& level = scenario.levels[level_number];
  const long settle = static_cast<long>(level.settle_samples);
  const SampleTimes times{scenario.sample_period_s(), -settle, -settle, level.recorded(), offset_s};
  return simulate(scenario.plant, level.initial, excitation, times);
}

Record simulate_level(const Scenario& scenario, size_t level_number, uint64_t seed, double offset_s) {
  return simulate_level(scenario, level_number, level_excitation(scenario, level_number, seed), offset_s);
}

}  // namespace host_sim

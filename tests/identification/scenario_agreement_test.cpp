// Every shipped scenario through the fixed-point core and, from the same codes, through double precision: samples to
// estimates, 1e-6 of each standard deviation and far less of each value. Windows are the core's, everything in them is
// computed anew. Clean scenarios too: what rounding leaves of a scatter must not steer the weights.
#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/scaled_double.hpp"
#include "host_sim/plant/scenario/scenario.hpp"
#include "tests/accuracy/redraw.hpp"
#include "tests/identification/double_energies.hpp"

namespace {

constexpr size_t kFirst = 3;  // the end corrections and the smoothed sign of the first sample look three samples back

std::vector<reference::LevelEnergies> all_levels(const accuracy::Redraw& redraw) {
  std::vector<reference::LevelEnergies> levels;
  for (int l = 0; l < redraw.table().level_count; ++l) {
    const firmware::Level& level = redraw.table().level[l];
    std::vector<uint32_t> samples;
    for (int b = 0; b < level.batch_count; ++b) samples.push_back(level.batch[b].samples);
    levels.push_back(reference::energies(redraw.configuration(), redraw.codes()[static_cast<size_t>(l)], level.periodic,
                                         samples, kFirst));
  }
  return levels;
}

class ScenarioAgreement : public testing::TestWithParam<std::string> {};

TEST_P(ScenarioAgreement, FixedPointIsDoublePrecisionToAMillionth) {
  accuracy::Redraw redraw(host_sim::load_scenario(GetParam()));
  for (const uint64_t seed : {11u, 12u}) {
    const firmware::Estimates& estimates = redraw.run(seed);
    const reference::Result expected = reference::estimate(redraw.configuration(), all_levels(redraw));
    ASSERT_EQ(expected.value.size(), redraw.configuration().unknown_count);
    for (int k = 0; k < redraw.configuration().unknown_count; ++k) {
      const double value = rig_file::to_double(estimates.parameters[k].value);
      const double deviation = rig_file::to_double(estimates.parameters[k].std);
      EXPECT_NEAR(value / expected.value(k), 1.0, 1e-8) << "unknown " << k << " seed " << seed;
      EXPECT_NEAR(deviation / expected.deviation(k), 1.0, 1e-6) << "unknown " << k << " seed " << seed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllNine, ScenarioAgreement, testing::ValuesIn(host_sim::shipped_scenario_names()),
                         [](const auto& name) { return name.param; });

}  // namespace

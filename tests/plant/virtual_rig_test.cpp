// The simulated rig as a sample source: order, time, phases, and codes that stand for the measured values.
#include "host_sim/virtual_rig/virtual_rig.hpp"

#include <gtest/gtest.h>

#include "tests/plant/scenario_texts.hpp"

namespace {

using host_sim::RigPhase;

// Level 1: 1000 samples settling, 2001 measured (2000 periods), 128 beyond. A second level: 500 settling, 1001
// measured, 128.
std::string two_levels() {
  return plant_test::spoiled("[sensors]",
                             "[[level]]\nkind = \"sine\"\namplitude_N = 40.0\nfrequency_Hz = 4.0\nsettle_s = "
                             "0.5\nduration_s = 1.0\n[sensors]");
}

TEST(VirtualRig, YieldsLevelsInOrderAndOwnsTheClock) {
  host_sim::VirtualRig rig(host_sim::parse_scenario(two_levels(), "two.toml"), 1);
  EXPECT_EQ(rig.total_samples(), 3129u + 1629u);
  EXPECT_EQ(rig.phase(), RigPhase::kWaiting);
  firmware::RawSample sample;
  size_t count[2][3] = {};
  for (uint32_t i = 0; i < 3129 + 1629; ++i) {
    ASSERT_EQ(rig.read(sample), hal::SampleResult::kSample);
    EXPECT_EQ(sample.sequence, i);
    EXPECT_EQ(rig.now_ns(), i * 1000000ull);
    EXPECT_EQ(sample.time_ns, rig.now_ns());
    EXPECT_EQ(rig.first_of_level(), i == 0 || i == 3129);
    EXPECT_EQ(rig.last_of_level(), i == 3128 || i == 4757);
    const int phase = static_cast<int>(rig.phase()) - static_cast<int>(RigPhase::kSettling);
    ASSERT_TRUE(phase >= 0 && phase < 3);
    ++count[rig.level()][phase];
  }
  EXPECT_EQ(rig.read(sample), hal::SampleResult::kEnd);
  EXPECT_EQ(rig.phase(), RigPhase::kDone);
  EXPECT_EQ(rig.read(sample), hal::SampleResult::kEnd);
  const size_t expected[2][3] = {{1000, 2001, 128}, {500, 1001, 128}};
  for (int level = 0; level < 2; ++level)
    for (int phase = 0; phase < 3; ++phase) EXPECT_EQ(count[level][phase], expected[level][phase]);
}

// Sample 1000 of level 1 is t = 0: the cosine's crest, 20 N.
TEST(VirtualRig, CodesTimesUnitAreTheForce) {
  host_sim::VirtualRig rig(host_sim::parse_scenario(two_levels(), "two.toml"), 1);
  firmware::RawSample sample;
  for (int i = 0; i <= 1000; ++i) rig.read(sample);
  const auto& calibration = rig.measured().calibrations[0];
  EXPECT_EQ(calibration.quantity, firmware::Quantity::kForce);
  EXPECT_NEAR(sample.code[0][0] * calibration.unit_per_code, 20.0, 1e-5);
}

TEST(VirtualRig, SameSeedSameBytes) {
  const auto scenario =
      host_sim::parse_scenario(plant_test::spoiled("bits = 24", "bits = 16\nnoise_percent = 5.0"), "n.toml");
  host_sim::VirtualRig a(scenario, 9), b(scenario, 9), c(scenario, 10);
  firmware::RawSample x, y, z;
  bool differs = false;
  while (a.read(x) == hal::SampleResult::kSample) {
    b.read(y);
    c.read(z);
    for (int q = 0; q < firmware::kQuantities; ++q) {
      ASSERT_EQ(x.code[0][q], y.code[0][q]);
      differs |= x.code[0][q] != z.code[0][q];
    }
  }
  EXPECT_TRUE(differs);
}

}  // namespace

// A ripple that a torque sensor brings along.
#include "host_sim/data_check/channel/ripple.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/data_check/data_check.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;

rig_file::RigModel rig(const std::string& mass) {
  return rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = " + mass + "\n[[link]]\nbetween = [1, 0]\nviscous_N_s_m = \"estimate\"\n",
      "rig.toml");
}

// 20 s at 1 kHz of a mass that is driven at two levels; noise of half the force's mean, and a ripple of `ripple` that wanders
// by 1 % over the record. A tone acts beside them.
Record driven(double ripple, double tone_Hz, double tone, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.5);
  Record record;
  record.file = "made.csv", record.sample_period_s = 1e-3;
  record.channels = {{"force_1_N", Quantity::kForce, 1, {}}, {"velocity_1_m_s", Quantity::kVelocity, 1, {}}};
  double v = 0.0, phase = 0.0;
  for (int i = 0; i < 20000; ++i) {
    const double t = 1e-3 * i, level = t < 10 ? 1.0 : 1.2, acting = level + tone * std::sin(2 * M_PI * tone_Hz * t);
    phase += 2 * M_PI * (366.0 + 0.2 * t) * 1e-3;
    record.channels[0].values.push_back(acting + noise(random) + ripple * std::sin(phase));
    record.channels[1].values.push_back(v);
    v += 1e-3 * (acting - v) / 0.5;
  }
  return record;
}

std::vector<std::string> told(const Record& record, const rig_file::RigModel& model) {
  return host_sim::data_check::ripples_of(host_sim::data_check::check({record}, &model));
}

TEST(Ripple, OfATorqueIsToldWithItsFrequency) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const std::vector<std::string> said = told(driven(0.15, 0, 0, seed), rig("\"estimate\""));  // 4 % of its power
    ASSERT_EQ(said.size(), 1u) << seed;
    const size_t at = said[0].find("near ");
    const double hertz = std::stod(said[0].substr(at + 5));
    EXPECT_NEAR(hertz, 368.0, 3.0);
    EXPECT_EQ(said[0].rfind("force_1_N", 0), 0u);
  }
}

// Noise alone; a tone that moves the mass; one that moves it too fast for its velocity's band, but is most of the force; and a
// damper without a mass, whose force answers with harmonics of its own.
TEST(Ripple, IsNeitherNoiseNorExcitationNorADampersAnswer) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    EXPECT_TRUE(told(driven(0, 0, 0, seed), rig("2.0")).empty()) << seed;
    EXPECT_TRUE(told(driven(0, 3.0, 0.2, seed), rig("2.0")).empty()) << seed;
    EXPECT_TRUE(told(driven(0, 120.0, 1.0, seed), rig("2.0")).empty()) << seed;
    EXPECT_TRUE(told(driven(0.15, 0, 0, seed), rig("0.0")).empty()) << seed;
  }
}

// A joint that is turned to and fro every 10 s, read 100 times a second: its torque is friction of 3 N m, whose sign jumps, and a little
// of its damper. A square's harmonics fall with the frequency and stand far above the motion, and are no ripple.
TEST(Ripple, IsNotTheJumpsOfFriction) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 0.1);
    Record record;
    record.file = "joint.csv", record.sample_period_s = 0.01;
    record.channels = {{"force_1_N", Quantity::kForce, 1, {}}, {"velocity_1_m_s", Quantity::kVelocity, 1, {}}};
    for (int i = 0; i < 6000; ++i) {
      const double v = std::cos(2 * M_PI * 0.1 * 0.01 * i + 0.3 * seed);
      record.channels[0].values.push_back(std::copysign(3.0, v) + 0.5 * v + noise(random));
      record.channels[1].values.push_back(v + 1e-3 * noise(random));
    }
    EXPECT_TRUE(told(record, rig("\"estimate\"")).empty()) << seed;
  }
}

}  // namespace

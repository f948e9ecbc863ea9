// What a "none" of free runs promises, mass and spring unknown: what is half as strong again as a printed limit is
// named, what is a quarter of it is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "one_mass.hpp"
#include "two_masses.hpp"

namespace {

using diagnosis::DetectionLimit;
using diagnosis::Diagnosis;

rig_file::RigModel all_unknown() {
  rig_file::RigModel rig = one_mass::rig();
  rig.dofs[0].mass_kg.estimate = rig.links[0].stiffness_N_m.estimate = true;
  return rig;
}

// The friction of the plant is free to choose: one that grows with the square of the rate.
Diagnosis with_drag(double drag_N_s2_m2, uint64_t seed) {
  return diagnosis::diagnose(all_unknown(), {one_mass::record([&](double v) { return drag_N_s2_m2 * v * v; }, seed)},
                             {});
}

const DetectionLimit* limit_of(const Diagnosis& d, const std::string& effect) {
  for (const DetectionLimit& l : d.minimum_detectable)
    if (l.effect == effect && l.where == "link 1-0") return &l;
  return nullptr;
}

TEST(RunLimits, HalfAsMuchAgainIsNamedAndAQuarterIsNot) {
  for (const uint64_t seed : {61, 62, 63}) {
    const Diagnosis quiet = with_drag(0, seed);
    ASSERT_EQ(two_masses::said(quiet), "none") << seed;
    const DetectionLimit* drag = limit_of(quiet, "quadratic_damping");
    ASSERT_NE(drag, nullptr);
    EXPECT_EQ(drag->unit, "N s^2/m^2");
    const Diagnosis named = with_drag(1.5 * drag->strength, seed);
    const bool in_a_set = std::any_of(named.ambiguous_with.begin(), named.ambiguous_with.end(),
                                      [](const auto& p) { return p.effect == "quadratic_damping"; });
    EXPECT_TRUE(named.names("quadratic_damping", "link 1-0") || in_a_set) << two_masses::said(named);
    EXPECT_EQ(two_masses::said(with_drag(0.25 * drag->strength, seed)), "none") << seed;
  }
}

// rms of d v |v| over c rms(v), of what the channel says of the motion: slopes over 4 ms of displacements of 2 mm and more.
TEST(RunLimits, ThePercentageIsOfTheDampingForce) {
  const host_sim::Record record = one_mass::record([](double) { return 0.0; }, 64);
  const Diagnosis quiet = diagnosis::diagnose(all_unknown(), {record}, {});
  const DetectionLimit* drag = limit_of(quiet, "quadratic_damping");
  ASSERT_NE(drag, nullptr);
  const std::vector<double>& x = record.channels[1].values;
  double squares = 0, fourths = 0;
  for (size_t i = 3; i + 3 < x.size(); ++i) {
    const double v = (3 * (x[i + 3] - x[i - 3]) + 2 * (x[i + 2] - x[i - 2]) + x[i + 1] - x[i - 1]) / 28 / 2e-3;
    squares += v * v, fourths += v * v * v * v;
  }
  const double n = static_cast<double>(x.size());
  const double expected =
      100 * drag->strength * std::sqrt(fourths / n) / (one_mass::kViscous_N_s_m * std::sqrt(squares / n));
  EXPECT_NEAR(drag->percent_of_damping_force, expected, 0.1 * expected);
}

// One tone: a spring that the rig file lacks and its unknown mass make one motion.
TEST(RunLimits, WhatTheRigsOwnNumbersMakeIsNotInTheData) {
  rig_file::RigModel rig = all_unknown();
  rig.links[0].stiffness_N_m.estimate = false, rig.links[0].stiffness_N_m.value = 0;
  host_sim::Record tone;
  tone.file = "tone.csv", tone.sample_period_s = 2e-3;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> force, place;
  for (int i = 0; i < 10000; ++i) {  // 2 kg and 3 N s/m at 2 Hz, 20 mm
    const double w = one_mass::kTwoPi * 2, t = 2e-3 * i;
    place.push_back(0.02 * std::sin(w * t) + 2e-5 * normal(random));
    force.push_back(0.02 * (-2 * w * w * std::sin(w * t) + 3 * w * std::cos(w * t)) + 0.005 * normal(random));
  }
  tone.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, force},
                   {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, place}};
  const Diagnosis d = diagnosis::diagnose(rig, {tone}, {});
  ASSERT_EQ(two_masses::said(d), "none");
  const DetectionLimit *spring = limit_of(d, "stiffness_error"), *offset = limit_of(d, "force_offset");
  ASSERT_NE(spring, nullptr);
  ASSERT_NE(offset, nullptr);
  EXPECT_TRUE(std::isinf(spring->strength)) << spring->strength;
  EXPECT_TRUE(std::isfinite(offset->strength));
}

}  // namespace

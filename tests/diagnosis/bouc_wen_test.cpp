// A mass on a spring with a hysteretic element (Bouc 1967, Wen 1976) whose loop stiffens as it loads: what bristles that bend and a
// hardening spring make together, none of them exactly. Over short windows the rig as given follows it by its own states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kRate_Hz = 1000, kDuration_s = 10;
constexpr int kFiner = 20;
constexpr double kMass_kg = 2, kSpring_N_m = 5e4, kDamper_N_s_m = 10;

// z' = loop w - 1000 (0.8 |w| z - 1.1 w |z|): along a reversal it is stiffer by up to 1900 z N/m, as it loads by 300 z N/m.
host_sim::Record recorded(double loop_N_m, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> phase(0, kTwoPi), hertz(5, 80);
  std::vector<double> omega, start;
  for (int i = 0; i < 70; ++i) omega.push_back(kTwoPi * hertz(random)), start.push_back(phase(random));
  const auto force = [&](double t) {
    double sum = 0;
    for (size_t i = 0; i < omega.size(); ++i) sum += std::sin(omega[i] * t + start[i]);
    return 100 * std::sqrt(2 / 70.0) * sum;
  };
  std::vector<double> forces, ways;
  double x = 0, v = 0, z = 0;
  const double h = 1 / (kRate_Hz * kFiner);
  for (int k = 0; k < static_cast<int>(kRate_Hz * kDuration_s); ++k) {
    forces.push_back(force(k / kRate_Hz)), ways.push_back(x);
    for (int i = 0; i < kFiner; ++i) {  // leapfrog: second order in h
      const double f = force(k / kRate_Hz + (i + 0.5) * h);
      x += 0.5 * h * v;
      const double half = z + 0.5 * h * (loop_N_m * v - 1000 * (0.8 * std::abs(v) * z - 1.1 * v * std::abs(z)));
      z += h * (loop_N_m * v - 1000 * (0.8 * std::abs(v) * half - 1.1 * v * std::abs(half)));
      v += h * (f - kSpring_N_m * x - kDamper_N_s_m * v - half) / kMass_kg;
      x += 0.5 * h * v;
    }
  }
  double square = 0;
  for (const double y : ways) square += y * y / static_cast<double>(ways.size());
  std::normal_distribution<double> normal(0, 0.003 * std::sqrt(square));
  for (double& y : ways) y += normal(random);
  host_sim::Record record;
  record.file = "loop.csv", record.sample_period_s = 1 / kRate_Hz;
  record.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, forces},
                     {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, ways}};
  return record;
}

diagnosis::Diagnosis answer_to(const host_sim::Record& record) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = kMass_kg;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.estimate = rig.links[0].viscous_N_s_m.estimate = true;
  return diagnosis::diagnose(rig, {record}, {});
}

TEST(BoucWen, WithoutItsLoopNothingIsMissing) {
  const diagnosis::Diagnosis d = answer_to(recorded(0, 1));
  EXPECT_EQ(two_masses::said(d), "none");
  EXPECT_NEAR(two_masses::value_of(d.baseline, "stiffness[1-0]"), kSpring_N_m, 0.01 * kSpring_N_m);
  EXPECT_NEAR(two_masses::value_of(d.baseline, "viscous[1-0]"), kDamper_N_s_m, 0.05 * kDamper_N_s_m);
}

// Named or in the set; and no more than it is: the loop's own law is none of the vocabulary.
TEST(BoucWen, HysteresisIsAmongWhatIsNamed) {
  const diagnosis::Diagnosis d = answer_to(recorded(0.8 * kSpring_N_m, 2));
  const diagnosis::NamedPlace loop{"presliding_hysteresis", "link 1-0"};
  bool told = std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), loop) != d.ambiguous_with.end();
  for (const diagnosis::Cause& c : d.causes) told = told || loop == diagnosis::NamedPlace{c.effect, c.where};
  EXPECT_TRUE(told) << two_masses::said(d);
  EXPECT_NE(d.verdict, diagnosis::Verdict::kExplained);
  ASSERT_EQ(d.gain.size(), 1u);
  EXPECT_GT(d.gain[0], 1.3);
}

}  // namespace

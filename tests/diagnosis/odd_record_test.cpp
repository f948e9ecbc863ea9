// Records of which one is another rig's, a mass that the rig file forgets, and records that hold nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/diagnosis/numbers/parameter_status.hpp"
#include "one_mass.hpp"

namespace {

using namespace diagnosis;
using host_sim::Quantity;
using host_sim::Record;

// 2 kg on 800 N/m, let go at x0: x = x0 e^(-a t) (cos w t + a / w sin w t), a = c / 4, w^2 = 400 - a^2; 6 s at 250 Hz, noise of 0.3 % of x0.
Record decay(double x0, double viscous_N_s_m, unsigned seed) {
  const double a = viscous_N_s_m / 4, w = std::sqrt(400 - a * a);
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.003 * std::abs(x0));
  std::vector<double> x;
  for (int k = 0; k < 1500; ++k) {
    const double t = k / 250.0;
    x.push_back(x0 * std::exp(-a * t) * (std::cos(w * t) + a / w * std::sin(w * t)) + noise(random));
  }
  Record record;
  record.file = std::to_string(seed) + ".csv", record.sample_period_s = 1 / 250.0;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, x}};
  return record;
}

// 4 N s/m and once 6.4, whichever stands where: the last of several decays is the unseen one, and it was "explained" beside a simulation
// that missed 16 % of it.
TEST(OddRecord, IsToldWhereverItStands) {
  for (const size_t odd : {0, 1, 2}) {
    std::vector<Record> records;
    for (size_t r = 0; r < 3; ++r)
      records.push_back(decay(r == 1 ? -0.02 : 0.03, r == odd ? 6.4 : 4.0, static_cast<unsigned>(r)));
    const Diagnosis d = diagnose(one_mass::rig(2, 800), records, {});
    // that of the middle looks like a drift of the damper as well
    EXPECT_TRUE(d.odd_record.has_value() || d.names("drifting_viscous", "link 1-0")) << odd;
    if (odd != 1) {
      EXPECT_GT(d.odd_record.value().missed_percent, 5);
    }
    EXPECT_TRUE(d.verdict == Verdict::kUnknown || d.verdict == Verdict::kPartly) << verdict_word(d.verdict);
    for (const Parameter& p : d.extended.parameters) {
      EXPECT_STRNE(status_word(p, d.extended_fits()), "VALID") << p.name;
    }
  }
}

TEST(OddRecord, IsNoneOfOneRig) {
  for (const unsigned seed : {10u, 20u, 30u}) {
    const Diagnosis d = diagnose(one_mass::rig(2, 800),
                                 {decay(0.03, 4, seed), decay(-0.002, 4, seed + 1), decay(0.01, 4, seed + 2)}, {});
    EXPECT_FALSE(d.odd_record.has_value()) << seed;
    EXPECT_EQ(d.verdict, Verdict::kNone) << seed;
    EXPECT_NEAR(d.baseline.parameters.at(0).value, 4, 4 * d.baseline.parameters.at(0).std) << seed;
  }
}

// 2 kg on 4000 N/m and 8 N s/m to the ground, 1.5 kg on 3000 N/m and 6 N s/m above it, of which the rig file says nothing: an unmodelled
// resonance of 1.5 kg at sqrt(3000 / 1.5) / 2 pi = 7.12 Hz, damped by 6 / (2 sqrt(3000 * 1.5)) = 0.0447 of its critical damping. Forty tones from 1
// to 20 Hz on the first mass; the steady motion of each from its two equations, 20 s at 500 Hz.
Record forgotten_mass(unsigned seed) {
  constexpr double kTwoPi = 6.28318530717958647692;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(0, kTwoPi);
  std::normal_distribution<double> noise;
  const size_t count = 10000;
  std::vector<double> f(count), x(count), a(count);
  for (int i = 0; i < 40; ++i) {
    const double w = kTwoPi * (1 + 0.4874 * i), phase = turn(random);
    const std::complex<double> above(3000, 6 * w), ground(4000, 8 * w), m2 = above - 1.5 * w * w;
    const std::complex<double> first = 1.0 / (ground + above - 2.0 * w * w - above * above / m2);
    for (size_t k = 0; k < count; ++k) {
      const std::complex<double> at = std::polar(1.0, w * static_cast<double>(k) / 500 + phase);
      f[k] += at.real(), x[k] += (first * at).real(), a[k] -= w * w * (first * at).real();
    }
  }
  for (size_t k = 0; k < count; ++k) x[k] += 1e-5 * noise(random), a[k] += 0.02 * noise(random);
  Record record;
  record.file = "forgotten.csv", record.sample_period_s = 1 / 500.0;
  record.channels = {{"force_1_N", Quantity::kForce, 1, f},
                     {"displacement_1_m", Quantity::kDisplacement, 1, x},
                     {"acceleration_1_m_s2", Quantity::kAcceleration, 1, a}};
  return record;
}

// Its damping stood at the 0.02 that it had been tried with, given as known, and the damper beside it was 14.3 +- 0.2 for 8.
TEST(ForgottenMass, IsNamedWithItsDamping) {
  const Diagnosis d = diagnose(one_mass::rig(2, 4000), {forgotten_mass(3)}, {});
  ASSERT_TRUE(d.names("unmodelled_resonance", "dof 1")) << verdict_word(d.verdict);
  const auto expect = [&](const std::string& name, double truth, double within) {
    for (const Parameter& p : d.extended.parameters)
      if (p.name == name) {
        EXPECT_NEAR(p.value, truth, within * truth) << name;
        EXPECT_GT(p.std, 0) << name;
        return;
      }
    ADD_FAILURE() << name << " is not there";
  };
  expect("unmodelled_resonance[1]", 1.5, 0.03);
  expect("resonance_frequency[1]", 7.118, 0.01);
  expect("resonance_damping_ratio[1]", 0.0447, 0.1);
  expect("viscous[1-0]", 8, 0.1);
}

// White noise of an accelerometer at rest, and of one whose spring and damper are asked for: it was "explained" by presliding friction,
// four numbers VALID, or a spring went out as 6480 +- 750 N/m.
TEST(NothingButNoise, IsNoMotionOfARig) {
  rig_file::RigModel rig = one_mass::rig(1, 0);
  rig.links[0].stiffness_N_m.estimate = true;
  for (const size_t samples : {size_t{350}, size_t{600}})
    for (const unsigned seed : {1u}) {
      std::mt19937 random(seed);
      std::normal_distribution<double> noise;
      std::vector<double> a(samples);
      for (double& value : a) value = noise(random);
      Record record;
      record.file = "noise.csv", record.sample_period_s = 0.01;
      record.channels = {{"acceleration_1_m_s2", Quantity::kAcceleration, 1, a}};
      const Diagnosis d = diagnose(rig, {record}, {});
      EXPECT_EQ(d.verdict, Verdict::kUnknown) << samples << ' ' << seed;
      EXPECT_TRUE(d.causes.empty());
      EXPECT_TRUE(d.baseline.parameters.empty() && d.extended.parameters.empty());
      EXPECT_NE(d.cannot_describe, "");
    }
}

}  // namespace

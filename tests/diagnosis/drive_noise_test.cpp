// Noise of what drives a rig: at its level, and only where it acts.
#include "host_sim/diagnosis/motion/drive_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis::runs;

constexpr double kTwoPi = 6.283185307179586;

// 1 kg on 4 kN/m; a force of its own (1 kHz, 4 s) and any motion.
Prepared prepared(const std::vector<double>& force) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 1, rig.links[0].a = 1, rig.links[0].b = 0, rig.links[0].stiffness_N_m.value = 4000;
  std::vector<double> v;
  for (size_t i = 0; i < force.size(); ++i) v.push_back(std::sin(kTwoPi * 10 * 1e-3 * static_cast<double>(i)));
  host_sim::Record record;
  record.sample_period_s = 1e-3;
  record.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, force},
                     {"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, v}};
  return prepare(rig, record);
}

// A slow sine that is not whole in the record jumps from its end to its start: a jump of J has the power J^2 / (4 n) at two
// thirds of the band, and 100 N over 4000 samples would be taken for 0.8 N of noise. There is 0.2 N.
TEST(DriveNoise, IsNotThatOfTheRecordsEnds) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  Vec f(4000);
  for (Index i = 0; i < f.size(); ++i)
    f[i] = 50 * std::cos(kTwoPi * 2.5 * static_cast<double>(i) / 4000) + 0.2 * normal(random);
  EXPECT_NEAR(noise_level(f), 0.2, 0.02);
}

// Two blows of 300 N, 8 ms long, whose spectrum reaches all over the band, and 0.1 N of noise: the force window leaves
// noise in the blows alone, and of the level that shows between them.
TEST(DriveNoise, OfAHammerIsInItsBlows) {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  std::vector<double> f(4000);
  for (size_t i = 0; i < f.size(); ++i) f[i] = 0.1 * normal(random);
  for (size_t at : {500u, 2500u})
    for (size_t i = 0; i < 8; ++i) f[at + i] += 300 * std::sin(kTwoPi / 2 * (static_cast<double>(i) + 0.5) / 8);
  const Prepared p = prepared(f);
  ASSERT_EQ(p.noise_in_blows[0].size(), p.force[0].size());
  const double scale = static_cast<double>(p.force[0].size()) / 4000;  // thinned
  const auto at = [&](double sample) { return static_cast<Index>(sample * scale); };
  EXPECT_NEAR(noise_of_force(p, 0), 0.1, 0.02);
  EXPECT_GT(p.noise_in_blows[0][at(504)], 0);
  EXPECT_EQ(p.noise_in_blows[0][at(1500)], 0);
  const Prepared noisy = DriveNoise().added_to(p);
  EXPECT_NE(noisy.force[0][at(504)], p.force[0][at(504)]);
  EXPECT_EQ((noisy.force[0] - p.force[0]).segment(at(600), at(1800)).cwiseAbs().maxCoeff(), 0);
}

// Without noise there is none, whatever the blow's spectrum.
TEST(DriveNoise, OfACleanHammerIsNone) {
  std::vector<double> f(4000, 0.0);
  for (size_t i = 0; i < 3; ++i) f[500 + i] = 300;
  const Prepared p = prepared(f);
  EXPECT_EQ(noise_of_force(p, 0), 0);
  EXPECT_FALSE(drives_have_noise({p}));
}

// The load cell of a shaker that is off reads its zero and 0.1 N of noise. A torque of 0.2 N rms in such noise may be off for good.
TEST(DriveNoise, OfAnIdleLoadCellIsNoLastingError) {
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  std::vector<double> idle, noisy;
  for (size_t i = 0; i < 4000; ++i) {
    idle.push_back(0.3 + 0.1 * normal(random));
    noisy.push_back(idle.back() + 0.2 * std::sqrt(2) * std::sin(kTwoPi * 10 * 1e-3 * static_cast<double>(i)));
  }
  EXPECT_EQ(lasting_error_of_force(prepared(idle), 0), 0);
  EXPECT_FALSE(drives_are_much_noise({prepared(idle)}));
  EXPECT_NEAR(lasting_error_of_force(prepared(noisy), 0), 0.1 / 8, 0.002);
}

hidden_rig::Draw drawn(uint64_t seed, const char* condition, const char* sensors, const char* hidden) {
  hidden_rig::Settings settings;
  settings.condition = condition, settings.sensors = sensors, settings.hidden = hidden, settings.rho_low = 0.1;
  return hidden_rig::make_draw(seed, settings);
}

// The blow's own spectrum, taken for noise, would explain four fifths of what a cubic spring leaves. Alone or in a set.
TEST(DriveNoise, OfAHammerHidesNoCause) {
  const hidden_rig::Draw draw = drawn(7400206, "hammer", "x", "cubic_stiffness");
  const std::string said = two_masses::said(diagnosis::diagnose(draw.rig, draw.records, {}));
  EXPECT_EQ(said.substr(said.find(' ') + 1), "cubic_stiffness on link 2-3");
}

TEST(DriveNoise, OfAHammerExplainsARightRig) {
  for (const char* sensors : {"x", "xva", "a"}) {
    const hidden_rig::Draw draw = drawn(7400207, "hammer", sensors, "none");
    EXPECT_EQ(two_masses::said(diagnosis::diagnose(draw.rig, draw.records, {})), "none") << sensors;
  }
}

}  // namespace

// Faults of one channel that another one would be blamed for: a displacement whose zero is elsewhere in every record, and a hum that the
// force's channel has and nothing acts.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "one_mass.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;

constexpr double kMass_kg = 2, kStiffness_N_m = 800, kViscous_N_s_m = 3, kRate_Hz = 250;  // 3.18 Hz
constexpr int kSamples = 5000;

// 20 s of x = sum of cos(w t + phase) / w over 24 tones from 1 to 6.75 Hz, and the force that moves it so: m x'' + c x' + k x. One percent of
// noise on each channel; hum_N: 50 Hz in the force's channel alone; zero_m: of the displacement's sensor.
host_sim::Record record(unsigned seed, double size, double zero_m, double hum_N) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 2 * M_PI);
  std::vector<double> f(kSamples), x = f, v = f, a = f;
  for (int tone = 0; tone < 24; ++tone) {
    const double w = 2 * M_PI * (1 + 0.25 * tone), at = phase(random);
    for (size_t k = 0; k < f.size(); ++k) {
      const double t = static_cast<double>(k) / kRate_Hz, c = size / w * std::cos(w * t + at),
                   s = size / w * std::sin(w * t + at);
      x[k] += c, v[k] -= w * s, a[k] -= w * w * c;
      f[k] += (kStiffness_N_m - kMass_kg * w * w) * c - kViscous_N_s_m * w * s;
    }
  }
  for (std::vector<double>* y : {&f, &x, &v, &a}) one_mass::add_noise(0.01, random, normal, *y);
  for (size_t k = 0; k < f.size(); ++k) {
    x[k] += zero_m;
    f[k] += hum_N * std::sin(2 * M_PI * 50 * static_cast<double>(k) / kRate_Hz);
  }
  return two_masses::of_one_mass("rig.csv", kRate_Hz, f, x, v, a);
}

void expect_damper(const Diagnosis& d) {
  const Parameter viscous = two_masses::parameter_of(d.baseline, "viscous[1-0]");
  EXPECT_NEAR(viscous.value, kViscous_N_s_m, 4 * viscous.std);
  EXPECT_LT(viscous.std, 0.05 * kViscous_N_s_m);
}

TEST(OwnZeros, OfEachRecordAreTold) {
  const Diagnosis d =
      diagnose(one_mass::rig(kMass_kg, kStiffness_N_m), {record(1, 0.01, 3e-3, 0), record(2, 0.01, -1e-3, 0)}, {}, {});
  EXPECT_EQ(two_masses::said(d), "explained, sensor_offset on channel displacement_1_m");
  const Parameter& zero = d.causes.at(0).parameters.at(0);
  EXPECT_NEAR(zero.value, 3e-3, 4 * zero.std + 3e-5);
  expect_damper(d);
}

TEST(OwnZeros, AreNotTakenWhereTheyStand) {
  const Diagnosis d =
      diagnose(one_mass::rig(kMass_kg, kStiffness_N_m), {record(3, 0.01, 0, 0), record(4, 0.01, 0, 0)}, {}, {});
  EXPECT_EQ(two_masses::said(d), "none");
  expect_damper(d);
}

// The simulation shakes with it, and the accelerometer has no such line.
TEST(HumOfTheForce, IsNotTheAccelerometers) {
  const Diagnosis d = diagnose(one_mass::rig(kMass_kg, kStiffness_N_m), {record(5, 0.01, 0, 0.5)}, {}, {});
  EXPECT_EQ(two_masses::said(d), "explained, mains_hum on channel force_1_N");
  EXPECT_NEAR(d.causes.at(0).parameters.at(0).value, 0.5, 0.1);
  expect_damper(d);
}

// Half of the way to the reading with every sample: late by one of them, 4 ms, of what is slow, and less of what is fast, of which it
// loses some too. As it is measured, with the noise of its own behind it.
TEST(FaultOfAChannel, IsToldThoughNoDelayPutsItRight) {
  host_sim::Record made = record(6, 0.01, 0, 0);
  double held = 0, rms = 0;
  std::vector<double>& v = made.channels[2].values;
  for (double value : v) rms += value * value / static_cast<double>(v.size());
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.01 * std::sqrt(rms));
  for (double& value : v) held += 0.5 * (value - held), value = held + noise(random);
  const Diagnosis d = diagnose(one_mass::rig(kMass_kg, kStiffness_N_m), {made}, {}, {});
  EXPECT_EQ(two_masses::said(d), "explained, sensor_delay on channel velocity_1_m_s");
  EXPECT_EQ(d.channels_left_out, std::vector<std::string>{"velocity_1_m_s"});
  EXPECT_NEAR(d.causes.at(0).parameters.at(0).value, 4e-3, 0.4e-3);
  expect_damper(d);
}

}  // namespace

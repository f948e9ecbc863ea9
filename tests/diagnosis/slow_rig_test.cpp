// Rigs whose whole motion is slower than a hertz: towers, ships, a joint that is turned by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "one_mass.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;

constexpr double kMass_kg = 2, kStiffness_N_m = 1.8, kViscous_N_s_m = 0.4;  // 0.151 Hz

// 45 or 90 s at 10 Hz of x = the sum of 1 mm cos(w t + phase) over twelve tones from 0.03 to 0.47 Hz, and the force that moves it so:
// m x'' + c x' + k x. One percent of noise on each channel.
host_sim::Record slow_record(int samples, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 2 * M_PI);
  std::vector<double> f(static_cast<size_t>(samples)), x = f, v = f, a = f;
  for (int tone = 0; tone < 12; ++tone) {
    const double w = 2 * M_PI * (0.03 + 0.04 * tone), at = phase(random);
    for (size_t k = 0; k < f.size(); ++k) {
      const double t = 0.1 * static_cast<double>(k), c = 1e-3 * std::cos(w * t + at), s = 1e-3 * std::sin(w * t + at);
      x[k] += c, v[k] -= w * s, a[k] -= w * w * c;
      f[k] += (kStiffness_N_m - kMass_kg * w * w) * c - kViscous_N_s_m * w * s;
    }
  }
  for (std::vector<double>* y : {&f, &x, &v, &a}) one_mass::add_noise(0.01, random, normal, *y);
  return two_masses::of_one_mass("slow.csv", 10, f, x, v, a);
}

TEST(SlowRig, IsRight) {
  for (const int samples : {450, 900}) {
    const Diagnosis d = diagnose(one_mass::rig(kMass_kg, kStiffness_N_m), {slow_record(samples, 11)}, {}, {});
    EXPECT_EQ(two_masses::said(d), "none") << samples;
    const Parameter viscous = two_masses::parameter_of(d.baseline, "viscous[1-0]");
    EXPECT_NEAR(viscous.value, kViscous_N_s_m, 4 * viscous.std) << samples;
    EXPECT_LT(viscous.std, 0.05 * kViscous_N_s_m) << samples;
  }
}

// A velocity that reads a tenth too much is its gain; the displacement and the acceleration say so.
TEST(SlowRig, AGainOfItsVelocityIsNamed) {
  host_sim::Record record = slow_record(900, 12);
  for (host_sim::Channel& c : record.channels)
    if (c.quantity == host_sim::Quantity::kVelocity)
      for (double& value : c.values) value *= 1.1;
  const Diagnosis d = diagnose(one_mass::rig(kMass_kg, kStiffness_N_m), {record}, {}, {});
  EXPECT_EQ(two_masses::said(d), "explained, sensor_gain on channel velocity_1_m_s");
}

}  // namespace

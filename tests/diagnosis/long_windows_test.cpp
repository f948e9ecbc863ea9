// Records of which short windows tell nothing: their start is what noise and steps of a channel make it.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "shaft.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;

constexpr double kTwoPi = 6.283185307179586;

// A shaft of 2e-3 kg m^2 with 4e-4 N m s/rad and friction of 0.05 N m runs up for 7 s, at 100 Hz: 0.5 N m take it towards 1100 rad/s with
// a time constant of 5 s, and 0.1 N m of 0.15 Hz move it on the way. The tacho reads anew every 150 ms: 14 of 15 rows repeat the last value. A
// twelfth of what is fitted, 0.4 s, holds three such steps, which miss about a third of its motion; the whole of it holds
// 33, and they miss 3 %.
host_sim::Record stepped_speed() {
  const double inertia = 2e-3, viscous = 4e-4, friction = 0.05, h = 1e-3;
  std::vector<double> torque, speed;
  double w = 0, read = 0;
  for (int k = 0; k < 7000; ++k) {
    const double drive = 0.5 + 0.1 * std::sin(kTwoPi * 0.15 * k * h);
    if (k % 150 == 0) read = w;
    if (k % 10 == 0) torque.push_back(drive), speed.push_back(read);
    w += h * (drive - viscous * w - friction * std::tanh(w / 0.1)) / inertia;
  }
  return shaft::record("wheel.csv", torque, speed);
}

TEST(LongWindows, ASpeedInStepsIsDescribedOverAllThatIsSeen) {
  const Diagnosis d = diagnose(shaft::rig(), {stepped_speed()}, {}, {});
  EXPECT_EQ(d.cannot_describe, "");
  const Parameter inertia = two_masses::parameter_of(d.baseline, "mass[1]");
  EXPECT_NEAR(inertia.value, 2e-3, std::max(2e-4, 3 * inertia.std));
}

// 2 kg on a spring of 3200 N/m (6.366 Hz) and a damper of 0.6 N s/m, on a base that shakes with 0.3 m/s^2 at 6.2 Hz. Its
// accelerometer drifts by 3 mm/s^2 below 0.4 Hz, which integrated twice is (6.2 / 0.3)^2 = 430 times as much of a displacement: more than that of
// the motion. Velocity with noise of 20 mm/s. With A the base's acceleration Z = -m A / (k - m w^2 + i c w) is the
// elongation, and V = A / (i w) + i w Z.
host_sim::Record on_drifting_base() {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const std::complex<double> i(0, 1);
  const double omega = kTwoPi * 6.2, mass = 2, stiffness = 3200, viscous = 0.6, amplitude = 0.3;
  const std::complex<double> z = -mass * amplitude / (stiffness - mass * omega * omega + i * viscous * omega),
                             v = amplitude / (i * omega) + i * omega * z;
  double drift[16];
  for (double& phase : drift) phase = kTwoPi * normal(random);
  std::vector<double> base, velocity;
  for (int k = 0; k < 4096; ++k) {
    const double t = k / 64.0;
    double slow = 0;
    for (int j = 0; j < 16; ++j) slow += 3e-3 / std::sqrt(8.0) * std::cos(kTwoPi * 0.0247 * (j + 1) * t + drift[j]);
    base.push_back(amplitude * std::cos(omega * t) + slow + 5e-4 * normal(random));
    velocity.push_back((v * std::exp(i * omega * t)).real() + 0.02 * normal(random));
  }
  host_sim::Record made;
  made.file = "shaker.csv", made.sample_period_s = 1 / 64.0;
  made.channels = {{"acceleration_base_m_s2", host_sim::Quantity::kAcceleration, rig_file::kBase, base},
                   {"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, velocity}};
  return made;
}

TEST(LongWindows, ABaseWhoseAccelerometerDriftsIsDescribed) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 2;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kBase;
  rig.links[0].stiffness_N_m.estimate = rig.links[0].viscous_N_s_m.estimate = true;
  const Diagnosis d = diagnose(rig, {on_drifting_base()}, {}, {});
  EXPECT_EQ(d.cannot_describe, "");
  EXPECT_NEAR(two_masses::value_of(d.baseline, "stiffness[1-base]"), 3200, 10);
  EXPECT_NEAR(two_masses::value_of(d.baseline, "viscous[1-base]"), 0.6, 0.15);
}

}  // namespace

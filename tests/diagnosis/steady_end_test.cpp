// A record that settles: at constant speed its end is noise, and what is missed there is noise over noise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "shaft.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;

// A motor of 0.01 kg m^2 with 0.04 N m s/rad and friction of 0.7 N m, 20 s at 100 Hz: its time constant is 0.25 s. Steps of the torque, rounded over 0.1 s, every
// 1.5 s, of 2 to 6 N m, move it for 13.5 s; then 5 N m hold it at (5 - 0.7) / 0.04 = 107 rad/s for the last 6.5 s, which the 30 % that
// are kept apart lie in. Noise of 0.3 rad/s.
host_sim::Record settling_motor() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  constexpr double kSteps_N_m[] = {4, 2, 6, 3, 5, 2.5, 5.5, 3.5, 6};
  const double h = 1e-3;
  std::vector<double> torque, speed;
  double w = 0, drive = 4;
  for (int k = 0; k < 20000; ++k) {
    drive += h / 0.1 * ((k < 13500 ? kSteps_N_m[k / 1500] : 5) - drive);
    if (k % 10 == 0) torque.push_back(drive), speed.push_back(w + 0.3 * normal(random));
    w += h * (drive - 0.04 * w - 0.7 * std::tanh(w / 0.1)) / 0.01;
  }
  return shaft::record("motor.csv", torque, speed);
}

// 0.3 rad/s of a motion of some 25 rad/s are 1.2 %; over the end alone they are all there is.
TEST(SteadyEnd, IsNotWhatARigIsJudgedBy) {
  const Diagnosis d = diagnose(shaft::rig(), {settling_motor()}, {}, {});
  EXPECT_EQ(two_masses::said(d), "none");
  EXPECT_LT(d.baseline.holdout_nrmse_percent.at(0), 5);
  EXPECT_NEAR(two_masses::value_of(d.baseline, "mass[1]"), 0.01, 5e-4);
}

// One step of the torque, 5 to 15 N m after 3.3 s of 12.2, read 0.1 s early against the speed: the windows that are kept apart from all over the
// record are steady as well. 0.5 rad/s of noise of a motion of (15 - 5) / 0.04 = 250 rad/s, 0.28 of it low: 0.5 / (250 sqrt(0.28 * 0.72))
// = 0.45 %; over steady windows alone it would be noise over noise, 100 %.
TEST(SteadyEnd, WindowsAsSteadyAreHeldAgainstTheWholeMotion) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> torque, speed;
  double w = (5 - 0.7) / 0.04;
  for (int k = 0; k < 12200; ++k) {
    const double read = k < 3300 ? 5 : 15, acts = k < 3400 ? 5 : 15;
    if (k % 10 == 0) torque.push_back(read), speed.push_back(w + 0.5 * normal(random));
    w += 1e-3 * (acts - 0.04 * w - 0.7) / 0.01;
  }
  const Diagnosis d = diagnose(shaft::rig(), {shaft::record("step.csv", torque, speed)}, {}, {});
  EXPECT_TRUE(d.names("sensor_delay", "channel torque_1_N_m")) << two_masses::said(d);
  EXPECT_NEAR(d.extended.holdout_nrmse_percent.at(0), 0.45, 0.1);
  EXPECT_LT(d.baseline.holdout_nrmse_percent.at(0), 10);
}

}  // namespace

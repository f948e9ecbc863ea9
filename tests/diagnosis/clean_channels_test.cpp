// Records so clean that the rig follows its displacement to the last digit: a fault of another channel is one all the same.
#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;
using two_masses::said;

constexpr double kTwoPi = 6.283185307179586, kRate_Hz = 1000, kDuration_s = 10;

// 2 kg on 8000 N/m and 12 N s/m at 24 tones of 4 to 27 Hz; the velocity late, the acceleration too large.
host_sim::Record recorded(double late_s, double gain) {
  std::vector<double> force, x, v, a;
  for (int i = 0; i < static_cast<int>(kRate_Hz * kDuration_s); ++i) {
    double at = 0, rate = 0, late = 0, slope = 0;
    for (int k = 0; k < 24; ++k) {
      const double w = kTwoPi * (4 + k), phase = w * i / kRate_Hz + 0.7 * k * k, amplitude = 1e-2 / w;
      at += amplitude * std::sin(phase), rate += amplitude * w * std::cos(phase);
      late += amplitude * w * std::cos(phase - w * late_s), slope -= amplitude * w * w * std::sin(phase);
    }
    x.push_back(at), v.push_back(late), a.push_back(gain * slope);
    force.push_back(2 * slope + 8000 * at + 12 * rate);
  }
  return two_masses::of_one_mass("clean.csv", kRate_Hz, force, x, v, a);
}

Diagnosis diagnosed(double late_s, double gain) {
  const rig_file::RigModel rig = rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 8000.0\n"
      "viscous_N_s_m = \"estimate\"\n",
      "clean.toml");
  return diagnose(rig, {recorded(late_s, gain)}, {});
}

TEST(CleanChannels, ARightOneIsRight) { EXPECT_EQ(said(diagnosed(0, 1)), "none"); }

// 0.5 ms are 1 to 8 % of the velocity and nothing of the displacement.
TEST(CleanChannels, ALateVelocityIsNamed) {
  const Diagnosis d = diagnosed(5e-4, 1);
  ASSERT_TRUE(d.names("sensor_delay", "channel velocity_1_m_s")) << said(d);
  EXPECT_NEAR(d.causes[0].parameters[0].value, 5e-4, 1e-5);
}

TEST(CleanChannels, AnAccelerationOfAnotherGainIsNamed) {
  const Diagnosis d = diagnosed(0, 1.05);
  ASSERT_TRUE(d.names("sensor_gain", "channel acceleration_1_m_s2")) << said(d);
  EXPECT_NEAR(d.causes[0].parameters[0].value, 0.05, 1e-3);
}

}  // namespace

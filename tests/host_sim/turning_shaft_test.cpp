// host_sim estimate on a shaft that turns and turns: an encoder that counts over, a speed in a unit of its own; and times that are no seconds.
#include <cmath>
#include <cstdio>
#include <random>

#include "tests/host_sim/program_test.hpp"

namespace {

constexpr const char* kRig =
    "schema = \"rig/1\"\nname = \"shaft\"\n[[dof]]\ninertia_kg_m2 = 0.02\n[[link]]\nbetween = [1, 0]\n"
    "viscous_N_m_s_rad = \"estimate\"\ncoulomb_N_m = \"estimate\"\n";
constexpr double kViscous = 0.05, kCoulomb = 0.3, kInertia = 0.02;

// 80 s at 100 Hz of v = 2.5 + 4 sin 0.7 t + 3 sin 2.9 t, its integral and the torque that turns it so, with a little noise on each. The angle
// is what an encoder of 2 half says of it, the speed times gain.
std::string turning(double half, double gain) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise;
  std::string text = "t_s,torque_1_N_m,angle_1_rad,angular_velocity_1_rad_s\n";
  for (int i = 0; i < 8000; ++i) {
    const double t = 0.01 * i, v = 2.5 + 4 * std::sin(0.7 * t) + 3 * std::sin(2.9 * t),
                 a = 2.8 * std::cos(0.7 * t) + 8.7 * std::cos(2.9 * t),
                 x = 2.5 * t + 4 / 0.7 * (1 - std::cos(0.7 * t)) + 3 / 2.9 * (1 - std::cos(2.9 * t));
    const double torque = kInertia * a + kViscous * v + kCoulomb * (v > 0 ? 1 : -1);
    char row[120];
    std::snprintf(row, sizeof row, "%.2f,%.9g,%.9g,%.9g\n", t, torque + 0.002 * noise(random),
                  (half > 0 ? std::remainder(x, 2 * half) : x) + 1e-4 * noise(random), gain * v + 0.01 * noise(random));
    text += row;
  }
  return text;
}

class TurningShaft : public test_support::ProgramTest {
 protected:
  void SetUp() override { workspace_.write("rig.toml", kRig); }
  auto estimated(const std::string& data) {
    workspace_.write("data.csv", data);
    return host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "out.json"});
  }
};

TEST_F(TurningShaft, IsRightThoughItsEncoderCountsOver) {
  for (const double half : {0.0, 3.14159265358979, 12.5}) {
    const auto result = estimated(turning(half, 1));
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(result.errors.find("counts over") != std::string::npos, half > 0) << result.errors;
    EXPECT_NEAR(value(json("out.json"), "viscous[1-0]"), kViscous, 0.02 * kViscous) << half;
    EXPECT_NEAR(value(json("out.json"), "coulomb[1-0]"), kCoulomb, 0.02 * kCoulomb) << half;
  }
}

// 0.6 of the speed that the angle has: that goes with the energy that it gains and loses, and no delay does.
TEST_F(TurningShaft, ASpeedInAUnitOfItsOwnIsNotLate) {
  const auto result = estimated(turning(0, 0.6));
  EXPECT_NE(result.output.find("sensor gain in channel angular_velocity_1_rad_s, -0.4"), std::string::npos)
      << result.output;
  EXPECT_EQ(result.output.find("late against"), std::string::npos) << result.output;
}

// A car that rolls out, of its speed alone: drag and friction pull at no place, so nothing has to be integrated. m v' = -(F + q v^2), of which
// v = v0 (tan(a - b t)), with v0 = sqrt(F / q), b = sqrt(F q) / m and tan a = v(0) / v0.
TEST_F(TurningShaft, ACoastDownNeedsNoDisplacement) {
  constexpr double kFriction = 8, kDrag = 0.3, kMass = 90;
  workspace_.write("rig.toml",
                   "schema = \"rig/1\"\nname = \"car\"\n[[dof]]\nmass_kg = 90\n[[link]]\nbetween = [1, 0]\ncoulomb_N = "
                   "\"estimate\"\n[[link.effect]]\nkind = \"quadratic_damping\"\ncoefficient = \"estimate\"\n");
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0, 0.01);
  std::string text = "t_s,velocity_1_m_s\n";
  const double v0 = std::sqrt(kFriction / kDrag), rate = std::sqrt(kFriction * kDrag) / kMass,
               start = std::atan(8 / v0);
  for (int i = 0; i < 1200; ++i) {
    const double t = 0.05 * i, v = start > rate * t ? v0 * std::tan(start - rate * t) : 0.0;
    char row[60];
    std::snprintf(row, sizeof row, "%.2f,%.9g\n", t, v + noise(random));
    text += row;
  }
  const auto result = estimated(text);
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.output.find("displacement of DOF 1 derived"), std::string::npos) << result.output;
  EXPECT_NEAR(value(json("out.json"), "coulomb[1-0]"), kFriction, 0.03 * kFriction) << result.output;
  EXPECT_NEAR(value(json("out.json"), "quadratic_damping[1-0]"), kDrag, 0.05 * kDrag) << result.output;
}

// Milliseconds as seconds: the samples are too slow for the rig's slowest mode, and nothing is simulated from them.
TEST_F(TurningShaft, TimesThatAreNoSecondsAreNotSimulated) {
  workspace_.write(
      "rig.toml",
      "schema = \"rig/1\"\nname = \"rig\"\n[[dof]]\nmass_kg = 2\n[[dof]]\nmass_kg = 1\n[[link]]\nbetween = [1, 0]\n"
      "stiffness_N_m = 4000\nviscous_N_s_m = \"estimate\"\n[[link]]\nbetween = [1, 2]\n"
      "stiffness_N_m = 3000\nviscous_N_s_m = \"estimate\"\n");
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  std::string text = "t_s,force_1_N,displacement_1_m,displacement_2_m\n";
  for (int i = 0; i < 5000; ++i) {
    char row[90];
    std::snprintf(row, sizeof row, "%d,%.6g,%.6g,%.6g\n", 2 * i, 20 * std::sin(0.05 * i),
                  0.006 * std::sin(0.05 * i - 0.2) + 1e-5 * noise(random),
                  0.007 * std::sin(0.05 * i - 0.3) + 1e-5 * noise(random));
    text += row;
  }
  const auto result = estimated(text);
  EXPECT_NE((result.output + result.errors).find("are the times in seconds?"), std::string::npos)
      << result.output << result.errors;
  EXPECT_NE(json("out.json")["mse_note"].get<std::string>().find("no simulation"), std::string::npos);
}

}  // namespace

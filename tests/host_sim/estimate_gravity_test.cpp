// host_sim estimate on what gravity pulls to its rest: arms and pendulums.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using test_support::row;

// An arm of 1.5 kg m^2 and 10.5 N m that a motor swings about straight up, 3 s to and fro: the angle is 3.14 at the mean, and gravity
// pulls to where it is zero, not to there. tau = 1.5 a + 10.5 sin(u) + 1 w + 1.2 sgn(w), u = 3.14 + 0.8 sin + 0.3 sin.
TEST_F(Estimate, GravityPullsToTheAnglesOwnZero) {
  workspace_.write("arm.toml",
                   "schema = \"rig/1\"\nname = \"arm\"\n[[dof]]\ninertia_kg_m2 = 1.5\n[[link]]\nbetween = [1, 0]\n"
                   "viscous_N_m_s_rad = \"estimate\"\ncoulomb_N_m = \"estimate\"\ngravity_torque_N_m = \"estimate\"\n");
  std::string text = "t_s,angle_1_rad,angular_velocity_1_rad_s,angular_acceleration_1_rad_s2,torque_1_N_m\n";
  const double w1 = 2.094395102393195, w2 = 5.3;
  for (int i = 0; i < 12000; ++i) {
    const double t = 5e-3 * i, u = 3.14 + 0.8 * std::sin(w1 * t) + 0.3 * std::sin(w2 * t),
                 v = 0.8 * w1 * std::cos(w1 * t) + 0.3 * w2 * std::cos(w2 * t),
                 a = -0.8 * w1 * w1 * std::sin(w1 * t) - 0.3 * w2 * w2 * std::sin(w2 * t);
    text += row({t, u, v, a, 1.5 * a + 10.5 * std::sin(u) + v + std::copysign(1.2, v)});
  }
  workspace_.write("arm.csv", text);
  const auto result = host_sim({"estimate", "--rig", "arm.toml", "--data", "arm.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  const auto out = json("out.json");
  EXPECT_NEAR(value(out, "gravity_torque[1-0]"), 10.5, 0.2);
  EXPECT_NEAR(value(out, "viscous[1-0]"), 1.0, 0.05);
  EXPECT_EQ(result.output.find("position of rest"), std::string::npos) << result.output;
}

const char* const kPendulum =
    "schema = \"rig/1\"\nname = \"pendulum\"\n[[dof]]\ninertia_kg_m2 = 1.0\n[[link]]\nbetween = [1, 0]\n"
    "gravity_torque_N_m = \"estimate\"\nviscous_N_m_s_rad = \"estimate\"\n";

// A pendulum of G N m and c N m s/rad per unit inertia, let go at u rad, as rows of the time and what reading(u, w) says. 3000 steps a second or
// more.
template <typename Reading>
std::string swing_of(double G, double c, double u, double rate_Hz, int samples, const Reading& reading) {
  std::string text;
  double w = 0.0;
  const int steps = static_cast<int>(std::ceil(3000.0 / rate_Hz));
  const double h = 1 / (rate_Hz * steps);
  for (int i = 0; i < samples; ++i) {
    char row[64];
    std::snprintf(row, sizeof row, "%.4f,%.6f\n", i / rate_Hz, reading(u, w));
    text += row;
    for (int k = 0; k < steps; ++k) {
      u += 0.5 * h * w;
      w += h * (-G * std::sin(u) - c * w);
      u += 0.5 * h * w;
    }
  }
  return text;
}

// A pendulum of a video, G = 19.5 N m, c = 0.02, whose angle reads `zero_rad` where it hangs.
std::string video_of_a_pendulum(double zero_rad, uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  return "t_s,angle_1_rad\n" +
         swing_of(19.5, 0.02, 0.3, 30, 3600, [&](double u, double) { return zero_rad + u + 0.0006 * normal(random); });
}

// A tenth of its swing. What it swings about is where it rests.
TEST_F(Estimate, ADecayIsCountedFromWhatItSwingsAbout) {
  workspace_.write("swing.toml", kPendulum);
  workspace_.write("swing.csv", video_of_a_pendulum(0.03, 4));
  const auto result = host_sim({"estimate", "--rig", "swing.toml", "--data", "swing.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NEAR(value(json("out.json"), "gravity_torque[1-0]"), 19.5, 0.1);
  EXPECT_NE(result.output.find("swings about 0.0"), std::string::npos) << result.output;
}

// The string was hung up again between two records: counted from one place for both, -0.16, neither swung about its rest and all numbers
// were hidden by noise.
TEST_F(Estimate, DecaysThatRestApartAreCountedFromTheirOwn) {
  workspace_.write("swing.toml", kPendulum);
  workspace_.write("one.csv", video_of_a_pendulum(0.12, 5));
  workspace_.write("two.csv", video_of_a_pendulum(-0.44, 6));
  const auto result =
      host_sim({"estimate", "--rig", "swing.toml", "--data", "one.csv", "--data", "two.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NEAR(value(json("out.json"), "gravity_torque[1-0]"), 19.5, 0.1);
  EXPECT_NE(result.output.find("swings about 0.12, -0.4"), std::string::npos) << result.output;
}

// A pendulum of G = 9.8 N m and c = 0.05 with a gyroscope, let go at `angle_rad`: 100 Hz, 60 s, 0.005 rad/s of noise.
std::string gyroscope_of_a_pendulum(double angle_rad) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  return "t_s,angular_velocity_1_rad_s\n" +
         swing_of(9.8, 0.05, angle_rad, 100, 6000, [&](double, double w) { return w + 0.005 * normal(random); });
}

// Behind the high-pass of an integrated angle sin(u) is another law: let go at 2.2 rad the torque came out as 8.2 +- 0.2 N m, VALID. At 0.3 rad
// it is the angle, and right.
TEST_F(Estimate, AGyroscopesWideSwingsAreNoMeasureOfGravity) {
  workspace_.write("swing.toml", kPendulum);
  workspace_.write("wide.csv", gyroscope_of_a_pendulum(2.2));
  workspace_.write("narrow.csv", gyroscope_of_a_pendulum(0.3));
  const auto wide = host_sim({"estimate", "--rig", "swing.toml", "--data", "wide.csv"});
  EXPECT_NE(wide.output.find("sin(u) is no longer its angle"), std::string::npos) << wide.output;
  EXPECT_EQ(wide.output.find(" VALID"), std::string::npos) << wide.output;
  const auto narrow = host_sim({"estimate", "--rig", "swing.toml", "--data", "narrow.csv", "--json", "out.json"});
  EXPECT_EQ(narrow.output.find("sin(u)"), std::string::npos) << narrow.output;
  EXPECT_NEAR(value(json("out.json"), "gravity_torque[1-0]"), 9.8, 0.05);
}

}  // namespace

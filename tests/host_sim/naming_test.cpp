// What estimate says of the model: a cause where one explains what does not fit, else that none does, and why.
#include <cmath>
#include <cstdio>
#include <random>

#include "host_sim/programs/results/warrant_result.hpp"
#include "tests/host_sim/program_test.hpp"

namespace {

host_sim::WarrantResult of_damping(firmware::Naming naming, double explains_percent) {
  host_sim::WarrantResult warrant;
  warrant.tested = true;
  warrant.named = {"quadratic_damping", "link 1-0", 3.0, 0.25, "N s^2/m^2"};
  warrant.rival = {"cubic_damping", "link 1-0", 7.0, 1.0, "N s^3/m^3"};
  warrant.rival_percent = 61.0;
  warrant.naming = naming;
  warrant.explains_percent = explains_percent;
  return warrant;
}

TEST(NamingText, ACauseIsSuspectedWithWhatItExplains) {
  EXPECT_EQ(
      warrant_text(of_damping(firmware::Naming::kExplains, 97.0)),
      "the board suspects quadratic damping on link 1-0, 3 +- 0.25 N s^2/m^2, takes away 97 % of what does not fit "
      "there; next best cubic damping on link 1-0 (61 % of its likelihood)");
}

TEST(NamingText, TheNearestIsNoSuspect) {
  const host_sim::WarrantResult nearest = of_damping(firmware::Naming::kInPart, 41.0);
  EXPECT_EQ(
      warrant_text(nearest),
      "the rig file lacks something that none of the board's candidates explains alone (nearest: quadratic damping "
      "on link 1-0, 3 +- 0.25 N s^2/m^2, takes away 41 % of what does not fit there, but it leaves more than noise; "
      "next nearest cubic damping on link 1-0)");
  EXPECT_NE(after_suspicion(nearest).find("looks for it"), std::string::npos);
}

// Shares of what is made by integration, and of a fault that cannot be, say nothing.
TEST(NamingText, NoShareIsToldOfWhatIsNotToldApart) {
  for (const firmware::Naming naming : {firmware::Naming::kTakenUp, firmware::Naming::kNoFault}) {
    const std::string text = warrant_text(of_damping(naming, 99.0));
    EXPECT_EQ(text.find('%'), std::string::npos) << text;
    EXPECT_NE(text.find(why_not_the_cause(of_damping(naming, 99.0))), std::string::npos) << text;
  }
}

// A pendulum, I = 0.2 kg m^2, G = 4.5 N m, c = 0.004 N m s, friction of 0.03 N m, that swings from 0.5 rad and comes to rest, seen by a
// gyroscope whose zero walks. Integrated, its angle goes on after the rest, where no torque does: that looks like a spring of about -G where the
// record is read from its beginning.
std::string gyroscope(double walk_rad_s) {
  constexpr double kInertia = 0.2, kGravity = 4.5, kViscous = 0.004, kFriction = 0.03, kStep_s = 5e-4;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::string text = "t_s,angular_velocity_1_rad_s\n";
  double angle = 0.5, rate = 0.0, zero = 0.0;
  for (int i = 0; i < 8000; ++i) {
    char row[64];
    std::snprintf(row, sizeof row, "%.3f,%.6g\n", i * 5e-3, rate + zero + 0.002 * normal(random));
    text += row;
    zero += walk_rad_s * normal(random);
    for (int step = 0; step < 10; ++step) {
      const double restoring = kGravity * std::sin(angle);
      const bool sticks = std::fabs(rate) < 1e-4 && std::fabs(restoring) < kFriction;
      const double friction = rate < 0 ? -kFriction : kFriction;
      rate = sticks ? 0.0 : rate - kStep_s * (restoring + kViscous * rate + friction) / kInertia;
      angle += kStep_s * rate;
    }
  }
  return text;
}

class NamingOnRecords : public test_support::ProgramTest {
 protected:
  // The warrant of an estimate with this walk of the gyroscope's zero.
  nlohmann::json warrant_with(double walk_rad_s) {
    workspace_.write(
        "rig.toml",
        "schema = \"rig/1\"\nname = \"wheel on a rod\"\n[[dof]]\ninertia_kg_m2 = \"estimate\"\n[[link]]\nbetween "
        "= [1, 0]\ngravity_torque_N_m = 4.5\nviscous_N_m_s_rad = \"estimate\"\n");
    workspace_.write("data.csv", gyroscope(walk_rad_s));
    said_ = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "out.json"}).output;
    return json("out.json")["warrant"];
  }
  std::string said_;
};

// The rig file has no friction, and says so much: something is missing, and it is no spring.
TEST_F(NamingOnRecords, WhatIntegrationMakesOfSlowNoiseIsNoStiffness) {
  const auto warrant = warrant_with(0.0012);
  EXPECT_FALSE(warrant.contains("suspect")) << warrant;
  ASSERT_TRUE(warrant.contains("nearest")) << warrant;
  EXPECT_NE(warrant["nearest"]["effect"], "stiffness_error");
  EXPECT_NE(said_.find("none of the board's candidates"), std::string::npos) << said_;
  EXPECT_EQ(said_.find("suspects"), std::string::npos) << said_;
  EXPECT_NEAR(value(json("out.json"), "mass[1]"), 0.2, 0.002);
}

}  // namespace

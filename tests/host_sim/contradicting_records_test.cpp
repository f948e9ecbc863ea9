// host_sim estimate on records that contradict each other: a wheel that rolls out twice, with another friction.
#include <cmath>
#include <cstdio>
#include <random>

#include "tests/host_sim/program_test.hpp"

namespace {

constexpr double kInertia = 0.01, kViscous = 1e-3;

// 200 Hz from 100 rad/s to rest: J w' = -(c w + F), so w = (w0 + F / c) exp(-c t / J) - F / c. With noise of 0.1 rad/s.
std::string coast_down(double coulomb, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, 0.1);
  std::string text = "t_s,angular_velocity_1_rad_s\n";
  for (int i = 0;; ++i) {
    const double t = 0.005 * i;
    const double rate = (100 + coulomb / kViscous) * std::exp(-kViscous * t / kInertia) - coulomb / kViscous;
    if (rate < 0) return text;
    char row[60];
    std::snprintf(row, sizeof row, "%.3f,%.6g\n", t, rate + noise(random));
    text += row;
  }
}

class ContradictingRecords : public test_support::ProgramTest {
 protected:
  auto estimated(double first, double second) {
    workspace_.write("rig.toml",
                     "schema = \"rig/1\"\nname = \"wheel\"\n[[dof]]\ninertia_kg_m2 = 0.01\n[[link]]\nbetween = [1, 0]\n"
                     "viscous_N_m_s_rad = \"estimate\"\ncoulomb_N_m = \"estimate\"\n");
    workspace_.write("cold.csv", coast_down(first, 1));
    workspace_.write("warm.csv", coast_down(second, 2));
    return host_sim(
        {"estimate", "--rig", "rig.toml", "--data", "cold.csv", "--data", "warm.csv", "--json", "out.json"});
  }
  std::string status_of(const std::string& name) {
    const auto out = json("out.json");
    for (const auto& p : out["parameters"])
      if (p["name"] == name) return p["status"];
    return "";
  }
};

TEST_F(ContradictingRecords, AreToldAndNoneOfTheirMeansIsValid) {
  const auto result = estimated(0.03, 0.02);
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(result.output.find("they contradict each other"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("coulomb[1-0] is 0.0"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("warm.csv"), std::string::npos) << result.output;
  EXPECT_EQ(status_of("coulomb[1-0]"), "MODEL_SUSPECT");
}

TEST_F(ContradictingRecords, AreNoneWhereTheyAgree) {
  const auto result = estimated(0.02, 0.02);
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.output.find("contradict"), std::string::npos) << result.output;
  EXPECT_EQ(status_of("coulomb[1-0]"), "VALID");
  EXPECT_NEAR(value(json("out.json"), "coulomb[1-0]"), 0.02, 0.0005);
}

}  // namespace

// A force that is turned over on a rig of which the rig file knows no mass and no spring.
#include "host_sim/programs/shared/turned_force.hpp"

#include <cmath>
#include <cstdio>
#include <random>

#include "tests/host_sim/program_test.hpp"

namespace {

const char* const kRig =
    "schema = \"rig/1\"\nname = \"cart\"\n[[dof]]\nmass_kg = \"estimate\"\n[[link]]\nbetween = [1, 0]\n"
    "stiffness_N_m = \"estimate\"\nviscous_N_s_m = \"estimate\"\n";

// Five tones, and the force that 2 kg, 800 N/m and 6 N s/m need for them, times `sign`; 0.1 % of noise.
std::string record(double sign) {
  constexpr double kHz[] = {1.1, 2.3, 3.7, 5.9, 7.3}, kAmplitude_m[] = {6e-3, 4e-3, 3e-3, 1.5e-3, 1e-3};
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::string text = "t_s,force_1_N,displacement_1_m\n";
  for (int i = 0; i < 10000; ++i) {
    double x = 0.0, v = 0.0, a = 0.0;
    for (int k = 0; k < 5; ++k) {
      const double w = 2.0 * M_PI * kHz[k], phase = w * i * 2e-3 + k * k;
      x += kAmplitude_m[k] * std::sin(phase), v += kAmplitude_m[k] * w * std::cos(phase);
      a -= kAmplitude_m[k] * w * w * std::sin(phase);
    }
    char row[96];
    std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g\n", i * 2e-3,
                  sign * (2.0 * a + 800.0 * x + 6.0 * v + 0.004 * normal(random)), x + 6e-6 * normal(random));
    text += row;
  }
  return text;
}

class TurnedForce : public test_support::ProgramTest {
 protected:
  void SetUp() override {
    workspace_.write("rig.toml", kRig);
    workspace_.write("turned.csv", record(-1));
    workspace_.write("right.csv", record(1));
  }
};

// -f = m a + k x + c v is f = (-m) a + (-k) x + (-c) v: no other than the signs of all numbers.
TEST_F(TurnedForce, IsTurnedBackBeforeItIsEstimated) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "turned.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  const auto out = json("out.json");
  EXPECT_NEAR(value(out, "mass[1]"), 2.0, 0.02);
  EXPECT_NEAR(value(out, "stiffness[1-0]"), 800.0, 8.0);
  EXPECT_NEAR(value(out, "viscous[1-0]"), 6.0, 0.2);
  for (const auto& p : out["parameters"]) EXPECT_EQ(p["status"], "VALID") << p.dump();
  EXPECT_NE(result.output.find("force_1_N is turned over"), std::string::npos) << result.output;
}

TEST_F(TurnedForce, IsTurnedBackBeforeItIsDiagnosed) {
  const auto result = host_sim({"diagnose", "--rig", "rig.toml", "--data", "turned.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_EQ(json("out.json")["verdict"], "none") << result.output;
  EXPECT_NE(result.errors.find("force_1_N is turned over"), std::string::npos) << result.errors;
}

// Where the rig file knows mass and spring, and the only motion could as well be the one that is turned over: that gives the same numbers.
TEST_F(TurnedForce, IsTurnedBackWhereTheRigFileTells) {
  std::string known = kRig;
  for (const char* from : {"mass_kg = \"estimate\"", "stiffness_N_m = \"estimate\""}) {
    const size_t at = known.find(from);
    ASSERT_NE(at, std::string::npos) << known;
    known.replace(known.find('"', at), 10, from[0] == 'm' ? "2.0" : "800.0");
  }
  workspace_.write("known.toml", known);
  const auto result = host_sim({"estimate", "--rig", "known.toml", "--data", "turned.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NEAR(value(json("out.json"), "viscous[1-0]"), 6.0, 0.2);
  EXPECT_NE(result.errors.find("force_1_N: polarity"), std::string::npos) << result.errors;
}

// The user's word: with --anyway the damper is as the record has it, -6 N s/m.
TEST_F(TurnedForce, IsLeftAsItIsAnyway) {
  workspace_.write("known.toml",
                   "schema = \"rig/1\"\nname = \"cart\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
                   "stiffness_N_m = 800.0\nviscous_N_s_m = \"estimate\"\n");
  host_sim({"estimate", "--rig", "known.toml", "--data", "turned.csv", "--json", "out.json", "--anyway"});
  EXPECT_LT(value(json("out.json"), "viscous[1-0]"), 0.0);
}

TEST_F(TurnedForce, ARightOneIsLeftAsItIs) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "right.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_NEAR(value(json("out.json"), "mass[1]"), 2.0, 0.02);
  EXPECT_EQ(result.output.find("turned over"), std::string::npos) << result.output;
}

host_sim::EstimateResult with(double mass, double stiffness, double std) {
  host_sim::EstimateResult result;
  result.parameters.resize(3);
  result.parameters[0].info.kind = firmware::TermKind::kMass, result.parameters[0].value = mass;
  result.parameters[1].info.kind = firmware::TermKind::kStiffness, result.parameters[1].value = stiffness;
  result.parameters[2].info.kind = firmware::TermKind::kViscous, result.parameters[2].value = 1;
  for (host_sim::ParameterResult& p : result.parameters) p.std = std;
  return result;
}

TEST(TurnedForceRule, AllMassesHaveToBeBelowNoughtBeyondChanceAndNoSpringAboveIt) {
  EXPECT_TRUE(says_turned(with(-2, -800, 0.4)));
  EXPECT_FALSE(says_turned(with(-2, -800, 0.6)));  // -2 is three deviations and a third below nought
  EXPECT_FALSE(says_turned(with(-2, 800, 0.4)));
  EXPECT_FALSE(says_turned(with(2, 800, 0.4)));
  host_sim::EstimateResult soft = with(-2, 30, 0.4);  // a spring that hardly shows says nothing
  soft.parameters[1].std = 10;
  EXPECT_TRUE(says_turned(soft));
  soft.parameters[1].std = 7;  // 30 is more than four deviations above nought
  EXPECT_FALSE(says_turned(soft));
}

// A known spring says which way the force acts; another test tells that (data_check/rig/rig_balance.hpp).
TEST(TurnedForceRule, WhatIsKnownSaysIt) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.estimate = true, rig.links[0].a = 1, rig.links[0].stiffness_N_m.estimate = true;
  host_sim::Record record;
  record.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {0, 1}}};
  EXPECT_FALSE(host_sim::may_be_turned(rig, {record}));  // nothing drives it
  record.channels.push_back({"force_1_N", host_sim::Quantity::kForce, 1, {0, 1}});
  EXPECT_TRUE(host_sim::may_be_turned(rig, {record}));
  rig.links[0].stiffness_N_m = {800, false};
  EXPECT_FALSE(host_sim::may_be_turned(rig, {record}));
}

}  // namespace

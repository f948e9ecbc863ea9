// Free motions of which a rate alone is recorded.
#include "host_sim/programs/estimate/from_its_end.hpp"

#include <cmath>
#include <cstdio>
#include <random>

#include "tests/host_sim/program_test.hpp"

using host_sim::Channel;
using host_sim::Quantity;
using host_sim::Record;

namespace {

Record record_of(std::vector<Channel> channels) {
  Record record;
  record.sample_period_s = 0.1;
  record.channels = std::move(channels);
  return record;
}

TEST(FromItsEnd, OnlyAFreeMotionThatIsIntegrated) {
  rig_file::RigModel model;
  model.links.resize(1);
  const Channel x{"displacement_1_m", Quantity::kDisplacement, 1, {1, 2}},
      v{"velocity_1_m_s", Quantity::kVelocity, 1, {1, 2}};
  const Channel f{"force_1_N", Quantity::kForce, 1, {1, 2}},
      other{"acceleration_2", Quantity::kAcceleration, 2, {1, 2}};
  const Channel base{"acceleration_base", Quantity::kAcceleration, rig_file::kBase, {1, 2}};
  EXPECT_TRUE(host_sim::begins_in_motion(model, {record_of({v})}));
  EXPECT_TRUE(host_sim::begins_in_motion(model, {record_of({x, v, other})}));
  EXPECT_FALSE(host_sim::begins_in_motion(model, {record_of({x, v})}));
  EXPECT_FALSE(host_sim::begins_in_motion(model, {record_of({f, v})}));
  EXPECT_FALSE(host_sim::begins_in_motion(model, {record_of({v, base})}));
  model.links[0].effects.push_back(
      {"presliding_hysteresis", {}, {}});  // its bristles remember which way they were bent
  EXPECT_FALSE(host_sim::begins_in_motion(model, {record_of({v})}));
}

TEST(FromItsEnd, LastFirstAndVelocitiesTurnedOver) {
  const auto turned = host_sim::backwards(
      {record_of({{"v", Quantity::kVelocity, 1, {1, 2, 3}}, {"a", Quantity::kAcceleration, 1, {4, 5, 6}}})});
  EXPECT_EQ(turned[0].channels[0].values, (std::vector<double>{-3, -2, -1}));
  EXPECT_EQ(turned[0].channels[1].values, (std::vector<double>{6, 5, 4}));
}

// 2 kg on 3200 N/m (40 rad/s) and dampers of 1 and 2.2 N s/m side by side, d = 3.2 / (2 * 2) = 0.8 1/s: x = cm e^-dt cos(wt), w =
// sqrt(1600 - 0.64) rad/s, with 1 % of noise, from the turning point or from the middle.
class RateAlone : public test_support::ProgramTest {
 protected:
  static constexpr double kDecay = 0.8, kPeriod_s = 1e-3;
  static std::string record(bool velocity, bool acceleration, double phase, unsigned seed, double late_s = 0.0) {
    const double w = std::sqrt(1600.0 - kDecay * kDecay);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::string text =
        std::string("t_s") + (velocity ? ",velocity_1_m_s" : "") + (acceleration ? ",acceleration_1_m_s2\n" : "\n");
    for (int i = 0; i < 4000; ++i) {
      const auto at = [&](double t_s, bool second) {
        const double u = 0.01 * std::exp(-kDecay * t_s), c = std::cos(w * t_s + phase), s = std::sin(w * t_s + phase);
        return second ? u * ((kDecay * kDecay - w * w) * c + 2.0 * kDecay * w * s) : u * (-kDecay * c - w * s);
      };
      const double t_s = kPeriod_s * i;
      char row[96];
      std::string line;
      std::snprintf(row, sizeof row, "%.3f", t_s), line += row;
      std::snprintf(row, sizeof row, ",%.8g", at(t_s, false) + 1e-3 * normal(random));
      if (velocity) line += row;
      std::snprintf(row, sizeof row, ",%.8g", at(t_s - late_s, true) + 4e-2 * normal(random));
      if (acceleration) line += row;
      text += line + "\n";
    }
    return text;
  }
  void rig(const std::string& link, const std::string& more = "") {
    workspace_.write(
        "rig.toml",
        "schema = \"rig/1\"\nname = \"slide\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n" + link + more);
  }
  // Both VALID, nothing suspected, and the truth in reach.
  void expect_answer(double truth, double within) {
    const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "r.csv", "--json", "out.json"});
    ASSERT_EQ(result.status, 0) << result.errors << result.output;
    EXPECT_NE(result.output.find("read from their end"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find("finds nothing"), std::string::npos) << result.output;
    const auto out = json("out.json");
    for (const auto& p : out["parameters"]) {
      if (p["name"] != "viscous[1-0]") continue;
      EXPECT_EQ(p["status"], "VALID") << result.output;
      EXPECT_NEAR(p["value"].get<double>(), truth, 4.0 * p["std"].get<double>()) << result.output;
      EXPECT_LT(p["std"].get<double>(), within) << result.output;
    }
  }
};

constexpr const char* kOpen = "stiffness_N_m = 3200.0\nviscous_N_s_m = \"estimate\"\n";

TEST_F(RateAlone, IsAnsweredFromItsEnd) {
  rig(kOpen);
  for (const double phase : {0.0, 1.2}) {
    workspace_.write("r.csv", record(true, false, phase, 11));
    expect_answer(3.2, 0.2);
    workspace_.write("r.csv", record(false, true, phase, 12));
    expect_answer(3.2, 0.4);
  }
}

// What the rig file gives is taken off with the right sign, whichever way time runs.
TEST_F(RateAlone, BesideADamperThatIsKnown) {
  workspace_.write("r.csv", record(true, false, 0.0, 13));
  rig("stiffness_N_m = 3200.0\nviscous_N_s_m = 3.2\ncoulomb_N = \"estimate\"\n");
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "r.csv", "--json", "out.json"});
  EXPECT_NE(result.output.find("read from their end"), std::string::npos) << result.output;
  EXPECT_LT(std::fabs(value(json("out.json"), "coulomb[1-0]")), 0.02)
      << result.output;  // of 1.28 N that the damper takes at first
}

// A stated delay is taken out of the channel that has it: 2 ms of 40 rad/s are 0.08 rad, of which the damper would get m w^2 0.002 s = 6.4.
TEST_F(RateAlone, WithAChannelThatIsLate) {
  workspace_.write("r.csv", record(true, true, 0.0, 14, 2e-3));
  rig(kOpen, "[[channel]]\nname = \"acceleration_1_m_s2\"\ndelay_us = 2000.0\n");
  expect_answer(3.2, 0.3);
}

}  // namespace

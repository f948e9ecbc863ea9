// What the gain of a force leaves open: whether it, or every mass and spring of the rig file, is off.
#include <nlohmann/json.hpp>

#include "host_sim/programs/estimate/channel_correction.hpp"
#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using host_sim::ChannelCorrection;
using host_sim::EstimateResult;
using host_sim::Quantity;
using host_sim::Record;

EstimateResult two_parameters() {
  EstimateResult result;
  result.parameters.resize(2);
  result.parameters[0].value = 20.0, result.parameters[0].std = 0.03;
  result.parameters[0].ci95_low = 19.94, result.parameters[0].ci95_high = 20.06;
  result.parameters[1].value = -3.0;  // nothing is known of it
  result.covariance = {{0.0009, 0.0}, {0.0, 0.0}};
  return result;
}

Record with(std::vector<const char*> forces) {
  Record record;
  for (const char* name : forces) record.channels.push_back({name, Quantity::kForce, 1, {}});
  record.channels.push_back({"velocity_1_m_s", Quantity::kVelocity, 1, {}});
  return record;
}

ChannelCorrection gain_of(const char* channel, bool by_channels) {
  ChannelCorrection correction;
  correction.channel = channel, correction.gain = 0.03, correction.std = 1e-4, correction.by_channels = by_channels;
  return correction;
}

// 3 % of 20 as a rectangle's half width: 0.6 / sqrt(3) = 0.34641; with 0.03 beside it sqrt(0.12 + 0.0009) = 0.347707; the ends go out by
// 2 * 0.34641 = 0.69282 to 19.24718 and 20.75282.
TEST(ForceScale, IsInTheIntervalOfEveryCoefficient) {
  EstimateResult result = two_parameters();
  tell_corrections({gain_of("force_1_N", false)}, {with({"force_1_N"})}, result);
  EXPECT_NEAR(result.parameters[0].std, 0.347707, 1e-6);
  EXPECT_NEAR(result.parameters[0].ci95_low, 19.24718, 1e-5);
  EXPECT_NEAR(result.parameters[0].ci95_high, 20.75282, 1e-5);
  EXPECT_NEAR(result.covariance[0][0], 0.1209, 1e-6);
  EXPECT_EQ(result.parameters[1].std, 0.0);
  EXPECT_NE(result.notes.back().find("would be 1.03 times as large"), std::string::npos) << result.notes.back();
}

TEST(ForceScale, IsNoQuestionWhereOtherChannelsOrForcesAnswerIt) {
  for (const bool by_channels : {true, false}) {
    EstimateResult result = two_parameters();
    const char* const channel = by_channels ? "velocity_1_m_s" : "force_1_N";
    tell_corrections({gain_of(channel, by_channels)}, {with({"force_1_N", "force_2_N"})}, result);
    EXPECT_EQ(result.parameters[0].std, 0.03);
    EXPECT_EQ(result.notes.back().find("times as large"), std::string::npos) << result.notes.back();
  }
}

// The same records with the masses 1 % too heavy in the rig file, and with a force that reads 1 % too much: both intervals hold the truth.
TEST_F(Estimate, AWrongMassThatLooksLikeAGainIsInTheInterval) {
  ASSERT_EQ(host_sim({"run", "--scenario", "paper_2dof", "--records", "r"}).status, 0);
  std::string rig = workspace_.read("r/rig.toml");
  for (size_t at = 0; (at = rig.find("mass_kg = 1.0", at)) != std::string::npos; ++at)
    rig.replace(at, 13, "mass_kg = 1.01");
  workspace_.write("heavy.toml", rig);
  const auto result = host_sim({"estimate", "--rig", "heavy.toml", "--data", "r/level_1.csv", "r/level_2.csv",
                                "r/level_3.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  for (const auto& p : json("out.json")["parameters"]) {
    const double truth = p["name"].get<std::string>().find("viscous") == 0 ? 6.0 : 10.0;
    EXPECT_LE(p["ci95"][0], truth) << result.output;
    EXPECT_GE(p["ci95"][1], truth) << result.output;
  }
}

}  // namespace

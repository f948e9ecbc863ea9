// host_sim estimate: what it finds, and where it says so.
#include <set>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using estimate_test::free_decay;

TEST_F(Estimate, FindsTheDamperAndSaysHowWell) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  const auto out = json("out.json");
  EXPECT_EQ(out["schema"], "estimate/1");
  EXPECT_NEAR(value(out, "viscous[1-0]"), 1.5, 1.5e-4);  // codes of 24 bits: far better than this
  EXPECT_EQ(out["parameters"][0]["status"], "VALID");
  EXPECT_EQ(out["parameters"][0]["unit"], "N s/m");
  EXPECT_EQ(out["samples"], 4000);
  EXPECT_NEAR(out["sample_rate_Hz"].get<double>(), 1000.0, 1e-6);
  EXPECT_LT(out["mse_percent"][0].get<double>(), 1e-3);  // its simulation runs as the rig did
}

TEST_F(Estimate, TableStandsOnStdoutAndNothingOnStderr) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv"});
  EXPECT_EQ(result.status, 0);
  for (const char* words :
       {"oscillator", "viscous[1-0]", "estimate", "95 %", "N s/m", "VALID", "4000 samples at 1000 Hz"})
    EXPECT_NE(result.output.find(words), std::string::npos) << words << " in\n" << result.output;
  EXPECT_EQ(result.errors, "");                              // no progress bar in a pipe
  EXPECT_EQ(result.output.find('\033'), std::string::npos);  // no colours either
  EXPECT_EQ(workspace_.entries(), (std::set<std::string>{"data.csv", "rig.toml"}));
}

TEST_F(Estimate, JsonOnStdoutIsAlone) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", "-"});
  EXPECT_EQ(nlohmann::json::parse(result.output)["schema"], "estimate/1");
  EXPECT_NE(result.errors.find("viscous[1-0]"), std::string::npos);
}

TEST_F(Estimate, FramesOfTheLogDecodeToTheSameEstimate) {
  const auto estimated = host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--log", "-"});
  const auto decoded = host_sim({"decode"}, estimated.output);
  EXPECT_EQ(decoded.status, 0);
  EXPECT_NE(decoded.output.find("viscous[1-0]"), std::string::npos);
  EXPECT_NE(decoded.output.find("mode = DONE"), std::string::npos);
}

TEST_F(Estimate, SameInputSameBytes) {
  for (const char* name : {"a", "b"})
    host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--json", std::string(name) + ".json", "--log",
              std::string(name) + ".log"});
  EXPECT_EQ(workspace_.read("a.json"), workspace_.read("b.json"));
  EXPECT_EQ(workspace_.read("a.log"), workspace_.read("b.log"));
  EXPECT_GT(workspace_.read("a.log").size(), 1000u);
}

// With a log a whole board solves once a second, without one its core does at the end alone.
TEST_F(Estimate, TheLogChangesNothing) {
  workspace_.write("other.csv", free_decay(2600));
  std::vector<std::string> arguments = {"estimate", "--rig", "rig.toml", "--data", "data.csv", "other.csv", "--json"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), arguments.begin(), arguments.end());
    return host_sim(more);
  };
  ASSERT_EQ(with({"alone.json"}).status, 0);
  ASSERT_EQ(with({"logged.json", "--log", "out.log"}).status, 0);
  EXPECT_EQ(workspace_.read("alone.json"), workspace_.read("logged.json"));
}

TEST_F(Estimate, SeveralRecordsAreLevelsOfOneEstimate) {
  const auto result =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "data.csv", "--data", "data.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(json("out.json")["samples"], 8000);
  EXPECT_EQ(json("out.json")["levels"], 2);
}

}  // namespace

// host_sim estimate where the data cannot answer.
#include <filesystem>
#include <string>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using estimate_test::free_decay;

TEST_F(Estimate, TooFewSamplesCannotAnswer) {
  workspace_.write("short.csv", free_decay(60));
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "short.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("record at least"), std::string::npos) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(workspace_.path() / "out.json"));
}

TEST_F(Estimate, ARigThatDoesNotMoveCannotAnswer) {
  std::string text = "t_s,displacement_1_m,velocity_1_m_s\n";
  for (int i = 0; i < 2000; ++i) text += std::to_string(i * 1e-3) + ",0,0\n";
  workspace_.write("still.csv", text);
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "still.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("displacement_1_m: dead: never changes"), std::string::npos) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(workspace_.path() / "out.json"));
  const auto anyway =
      host_sim({"estimate", "--rig", "rig.toml", "--data", "still.csv", "--json", "out.json", "--anyway"});
  EXPECT_EQ(anyway.status, 3);
  EXPECT_NE(anyway.errors.find("viscous[1-0]"), std::string::npos) << anyway.errors;
  EXPECT_EQ(json("out.json")["parameters"][0]["status"], "NO_EXCITATION");
}

}  // namespace

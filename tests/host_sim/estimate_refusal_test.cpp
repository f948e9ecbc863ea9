// host_sim estimate where the data cannot answer.
#include <filesystem>
#include <random>
#include <string>

#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using estimate_test::free_decay;
using test_support::row;

TEST_F(Estimate, TooFewSamplesCannotAnswer) {
  workspace_.write("short.csv", free_decay(60));
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "short.csv", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("record at least"), std::string::npos) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(workspace_.path() / "out.json"));
}

TEST_F(Estimate, ARigThatDoesNotMoveCannotAnswer) {
  std::string text = "t_s,displacement_1_m,velocity_1_m_s\n";
  for (int i = 0; i < 2000; ++i) text += row({i * 1e-3, 0, 0});
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

// Whatever multiplies both coefficients explains the motion as well: no noise hides them, and no other level shows them.
TEST_F(Estimate, WithoutAnyKnownForceSaysSo) {
  workspace_.write("free.toml",
                   "schema = \"rig/1\"\n[[dof]]\nmass_kg = 0\n[[link]]\nbetween = [1, 0]\nviscous_N_s_m = "
                   "\"estimate\"\ncoulomb_N = \"estimate\"\n");
  const auto result = host_sim({"estimate", "--rig", "free.toml", "--data", "data.csv"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("ILL_CONDITIONED, no force is known: none is measured"), std::string::npos)
      << result.errors;
  EXPECT_EQ(result.errors.find("noise"), std::string::npos) << result.errors;
  EXPECT_EQ(result.errors.find("measure instead"), std::string::npos) << result.errors;
}

// A car of 250 kg that rolls on after the 6 s of its record, 12 m/s to 6 m/s under 250 N: no cycles, no rest, and two coefficients of which
// so narrow a range shows the sum alone.
TEST_F(Estimate, ARunOutIsAskedForSpeeds) {
  workspace_.write("car.toml",
                   "schema = \"rig/1\"\n[[dof]]\nmass_kg = 250\n[[link]]\nbetween = [1, 0]\nviscous_N_s_m = "
                   "\"estimate\"\ncoulomb_N = \"estimate\"\n");
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::string text = "t_s,velocity_1_m_s\n";
  for (int i = 0; i < 3000; ++i) text += row({2e-3 * i, 12 - 2e-3 * i + 0.2 * normal(random)});
  workspace_.write("car.csv", text);
  const auto result = host_sim({"estimate", "--rig", "car.toml", "--data", "car.csv"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("a record over a wider range of speeds can"), std::string::npos) << result.errors;
  EXPECT_NE(result.output.find("where the motion that is integrated is slowest"), std::string::npos) << result.output;
}

}  // namespace

// Bad input is an answer: exit status 2, a message that names file, line or key and what was expected, and nothing left
// behind.
#include "tests/bad_input/bad_input.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/run_program.hpp"

namespace {

using bad_input::Case;

class BadInput : public ::testing::TestWithParam<Case> {};

TEST_P(BadInput, IsRefusedWithAMessageAndLeavesNothing) {
  const Case& bad = GetParam();
  const test_support::Workspace workspace;
  std::set<std::string> before;
  for (const auto& [name, content] : bad.files) {
    workspace.write(name, content);
    before.insert(name);
  }
  std::vector<std::string> command = {HOST_SIM};
  command.insert(command.end(), bad.arguments.begin(), bad.arguments.end());
  const test_support::ProgramResult result = test_support::run_program(command, workspace.path(), bad.input);
  EXPECT_EQ(result.status, 2) << result.errors;
  for (const std::string& words : bad.says)
    EXPECT_NE(result.errors.find(words), std::string::npos) << words << "\nin: " << result.errors;
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(workspace.entries(), before) << "files left behind";
}

// The cases above fail for their own fault alone: what they spoil is accepted unspoilt.
TEST(GoodInput, IsAccepted) {
  const test_support::Workspace workspace;
  workspace.write("rig.toml", bad_input::good_rig());
  workspace.write("data.csv", bad_input::good_data());
  std::vector<std::string> command = {HOST_SIM};
  for (const std::string& argument : bad_input::estimate_command()) command.push_back(argument);
  const test_support::ProgramResult result = test_support::run_program(command, workspace.path());
  EXPECT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(workspace.entries(), (std::set<std::string>{"data.csv", "out.json", "out.log", "rig.toml"}));
}

TEST(GoodInput, ScenarioIsAccepted) {
  const test_support::Workspace workspace;
  workspace.write("rig.toml", bad_input::good_rig());
  workspace.write("shaker.toml",
                  "schema = \"scenario/1\"\nrig = \"rig.toml\"\n[[level]]\nkind = \"sine\"\namplitude_N = 1\n"
                  "frequency_Hz = 2\ncycles = 10\n[truth]\n\"viscous[1-0]\" = 1.5\n");
  const auto result =
      test_support::run_program({HOST_SIM, "run", "--scenario", "shaker.toml", "--log", "out.log"}, workspace.path());
  EXPECT_EQ(result.status, 0) << result.errors;
}

std::string name_of(const ::testing::TestParamInfo<Case>& info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Rigs, BadInput, ::testing::ValuesIn(bad_input::broken_rigs()), name_of);
INSTANTIATE_TEST_SUITE_P(Data, BadInput, ::testing::ValuesIn(bad_input::broken_data()), name_of);
INSTANTIATE_TEST_SUITE_P(Commands, BadInput, ::testing::ValuesIn(bad_input::broken_commands()), name_of);

}  // namespace

// host_sim run, sweep, decode and dbc as a user meets them.
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <sstream>

#include "tests/host_sim/program_test.hpp"

namespace {

class RunCommand : public test_support::ProgramTest {};
class SweepCommand : public test_support::ProgramTest {};
class HelpOption : public test_support::ProgramTest {};

TEST_F(HelpOption, EveryCommandExplainsItself) {
  for (const char* command : {"run", "estimate", "diagnose", "decode", "dbc", "sweep"}) {
    const auto result = host_sim({command, "--help"});
    EXPECT_EQ(result.status, 0) << command;
    EXPECT_NE(result.output.find("Usage"), std::string::npos) << command;
    EXPECT_NE(host_sim({"--help"}).output.find(command), std::string::npos) << command;
  }
}

TEST_F(RunCommand, WithoutOptionsShowsThePapersRigAndWritesALog) {
  const auto result = host_sim({"run"});
  ASSERT_EQ(result.status, 0) << result.errors;
  for (const char* words : {"paper_3dof_random", "truth", "paper", "viscous[2-3]", "coulomb[3-0]", "VALID", "MSE"})
    EXPECT_NE(result.output.find(words), std::string::npos) << words << " in\n" << result.output;
  EXPECT_EQ(result.errors, "");
  EXPECT_EQ(workspace_.entries(), std::set<std::string>{"paper_3dof_random.log"});
  std::istringstream lines(workspace_.read("paper_3dof_random.log"));
  const std::regex candump(R"(\(\d{10}\.\d{6}\) vcan0 [0-9A-F]{3}#([0-9A-F]{2}){0,8})");
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) ASSERT_TRUE(std::regex_match(line, candump)) << line;
  EXPECT_GT(count, 100);
}

TEST_F(RunCommand, NoResultTakesTheScenariosPlace) {
  workspace_.write("own.toml", host_sim({"run", "--scenario", "paper_3dof_random", "--print"}).output);
  const std::string scenario = workspace_.read("own.toml");
  for (const std::string option : {"--json", "--log"}) {
    const auto result = host_sim({"run", "--scenario", "own.toml", option, "./own.toml"});
    EXPECT_EQ(result.status, 2) << option;
    EXPECT_NE(result.errors.find("is read by this command"), std::string::npos) << result.errors;
    EXPECT_EQ(workspace_.read("own.toml"), scenario);
  }
}

TEST_F(RunCommand, SeedDecidesEveryByte) {
  const auto log = [&](const char* seed) {
    return host_sim({"run", "--scenario", "paper_2dof_noise", "--seed", seed, "--log", "-"}).output;
  };
  const std::string first = log("7");
  EXPECT_GT(first.size(), 1000u);
  EXPECT_EQ(first, log("7"));
  EXPECT_NE(first, log("8"));
}

TEST_F(RunCommand, LogOnStdoutIsAloneAndDecodes) {
  const auto run = host_sim({"run", "--scenario", "paper_2dof", "--log", "-"});
  EXPECT_EQ(run.output.front(), '(');
  EXPECT_NE(run.errors.find("viscous[1-2]"), std::string::npos);  // the table
  const auto decoded = host_sim({"decode"}, run.output);
  for (const char* words : {"viscous[1-2]", "coulomb[2-0]", "N s/m", "quality = VALID"})
    EXPECT_NE(decoded.output.find(words), std::string::npos) << words;
  EXPECT_EQ(workspace_.entries(), std::set<std::string>{});
}

TEST_F(RunCommand, OneFrequencyIsNotCalledGood) {
  const auto result = host_sim({"run", "--scenario", "paper_3dof_one_frequency", "--json", "out.json"});
  EXPECT_EQ(result.status, 3);
  EXPECT_NE(result.errors.find("ILL_CONDITIONED"), std::string::npos) << result.errors;
  EXPECT_EQ(json("out.json")["parameters"][0]["status"], "ILL_CONDITIONED");
}

// A ninth level of some earlier run, which bench/level_*.csv would give to estimate with this run's. Other files are the user's.
TEST_F(RunCommand, LevelsOfAnEarlierRunAreNamed) {
  std::filesystem::create_directory(workspace_.path() / "bench");
  workspace_.write("bench/level_9.csv", "old");
  workspace_.write("bench/notes.csv", "mine");
  const auto result = host_sim({"run", "--scenario", "paper_2dof", "--records", "bench"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_EQ(result.errors, "note: bench/level_9.csv is not of this run\n");
  EXPECT_TRUE(workspace_.read("bench/level_9.csv") == "old");
}

TEST_F(RunCommand, ExportedRecordsEstimateToTheSameTruth) {
  ASSERT_EQ(host_sim({"run", "--scenario", "paper_3dof_random", "--records", "bench"}).status, 0);
  const auto result = host_sim({"estimate", "--rig", "bench/rig.toml", "--data", "bench/level_1.csv", "--data",
                                "bench/level_2.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NEAR(value(json("out.json"), "viscous[1-2]"), 20.0, 0.04);
  EXPECT_NEAR(value(json("out.json"), "coulomb[3-0]"), 1.0, 0.002);
}

TEST_F(RunCommand, WithoutACanInterfaceTheLogWayIsNamed) {
  const auto result = host_sim({"run", "--can", "no_such_can"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("--log"), std::string::npos) << result.errors;
  EXPECT_EQ(workspace_.entries(), std::set<std::string>{});
}

TEST_F(RunCommand, ReportIsOnePageThatNeedsNothingElse) {
  ASSERT_EQ(host_sim({"run", "--scenario", "paper_2dof", "--report", "page"}).status, 0);
  const std::string page = workspace_.read("page/index.html");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);
  // what the check says of a level stands at its name, without the colon behind a name that is none
  EXPECT_NE(page.find("<td>level 1</td><td>excitation</td>"), std::string::npos);
  EXPECT_EQ(page.find("<span class=\"sentence\">:"), std::string::npos);
  EXPECT_EQ(page.find("<td>all records</td>"), std::string::npos);
}

TEST_F(SweepCommand, ResultDoesNotDependOnTheWorkers) {
  for (const char* workers : {"1", "3"}) {
    const auto result = host_sim({"sweep", "--scenario", "paper_2dof_noise", "--seeds", "1..4", "--workers", workers,
                                  "--json", std::string(workers) + ".json"});
    ASSERT_EQ(result.status, 0) << result.errors;
  }
  EXPECT_EQ(workspace_.read("1.json"), workspace_.read("3.json"));
  const auto out = json("1.json");
  EXPECT_EQ(out["runs"].size(), 4u);
  EXPECT_EQ(out["summary"][0]["runs"], 4);
}

// As mpirun starts it: the same command several times, told by the environment which one of them it is.
TEST_F(SweepCommand, RanksTogetherWriteTheSameFile) {
  const std::vector<std::string> command = {HOST_SIM, "sweep", "--scenario", "paper_2dof_noise", "--seeds", "1..5"};
  const auto with = [&](std::vector<std::string> before, const std::string& json_name) {
    before.insert(before.end(), command.begin(), command.end());
    before.insert(before.end(), {"--workers", "1", "--json", json_name});
    return test_support::run_program(before, workspace_.path());
  };
  ASSERT_EQ(with({"env"}, "alone.json").status, 0);
  for (const char* rank : {"1", "2", "0"}) {  // rank 0 last: it waits for the others
    const auto result =
        with({"env", "OMPI_COMM_WORLD_SIZE=3", std::string("OMPI_COMM_WORLD_RANK=") + rank}, "ranks.json");
    ASSERT_EQ(result.status, 0) << result.errors;
  }
  EXPECT_EQ(workspace_.read("alone.json"), workspace_.read("ranks.json"));
  EXPECT_EQ(workspace_.entries(), (std::set<std::string>{"alone.json", "ranks.json"}));
}

// Within an allocation Slurm sets the number of tasks everywhere; that of a step is what srun has started.
TEST_F(SweepCommand, ASlurmAllocationWithoutSrunIsOneProcess) {
  const auto with = [&](std::vector<std::string> environment) {
    environment.insert(environment.begin(), {"timeout", "60", "env", "SLURM_JOB_ID=7", "SLURM_NTASKS=2"});
    environment.insert(environment.end(), {HOST_SIM, "sweep", "--scenario", "paper_2dof", "--seeds", "1..2",
                                           "--workers", "1", "--json", "sweep.json"});
    return test_support::run_program(environment, workspace_.path());
  };
  const auto alone = with({"SLURM_PROCID=0"});
  ASSERT_EQ(alone.status, 0) << alone.errors;
  const std::string expected = workspace_.read("sweep.json");
  const auto shell_of_a_step = with({"SLURM_PROCID=0", "SLURM_STEP_ID=0", "SLURM_STEP_NUM_TASKS=1"});
  ASSERT_EQ(shell_of_a_step.status, 0) << shell_of_a_step.errors;
  for (const char* rank : {"SLURM_PROCID=1", "SLURM_PROCID=0"}) {  // as srun starts them
    const auto result = with({rank, "SLURM_STEP_ID=0", "SLURM_STEP_NUM_TASKS=2"});
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(workspace_.entries().size(), std::string(rank) == "SLURM_PROCID=1" ? 2u : 1u) << rank;  // its part
  }
  EXPECT_EQ(workspace_.read("sweep.json"), expected);
}

}  // namespace

// What every command does at the terminal: version, bad numbers, a disk without room, logs without frames.
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/host_sim/program_test.hpp"

namespace {

class Terminal : public test_support::ProgramTest {
 protected:
  // Through a shell, with host_sim as $H.
  test_support::ProgramResult shell(const std::string& script) const {
    return test_support::run_program({"bash", "-c", "H=" + std::string(HOST_SIM) + "; " + script}, workspace_.path());
  }
};

TEST_F(Terminal, TellsItsVersion) {
  const auto result = host_sim({"--version"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "host_sim 0.1.0\n");
}

// The option that it stands for is not what is missing.
TEST_F(Terminal, AMistypedOptionIsNamedWithTheNearest) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"estimate", "--rigg", "r.toml", "--data", "d.csv"},
       "host_sim: --rigg is no option of host_sim estimate, did you mean --rig?"},
      {{"diagnose", "--rig", "r.toml", "--dta=d.csv"},
       "host_sim: --dta is no option of host_sim diagnose, did you mean --data?"},
      {{"estimate", "--data", "d.csv"}, "host_sim: --rig is required"},
      {{"estimate", "--rig", "r.toml", "--data", "d.csv", "--sample-rate", "x"}, "host_sim: --sample-rate: "},
      {{"--verzion"}, "host_sim: --verzion is no option of host_sim, did you mean --version?"},
      {{}, "host_sim: "}};
  for (const auto& [arguments, begin] : cases) {
    const auto result = host_sim(arguments);
    EXPECT_EQ(result.status, 2) << begin;
    EXPECT_EQ(result.errors.compare(0, begin.size(), begin), 0) << result.errors;
  }
}

TEST_F(Terminal, SeedsBelowZeroAreRefused) {
  const auto result = host_sim({"run", "--seed", "-1"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.errors.find("-1"), std::string::npos) << result.errors;
  EXPECT_TRUE(workspace_.entries().empty());
}

TEST_F(Terminal, AFullDiskIsNoticedByEveryCommand) {
  ASSERT_EQ(shell("$H run --scenario paper_1dof --records rig --log rig.log > table").status, 0);
  for (const char* command :
       {"$H dbc", "$H decode rig.log", "$H decode --csv rig.log", "$H run --print --scenario paper_1dof",
        "$H estimate --rig rig/rig.toml --data rig/level_1.csv", "$H --help", "$H --version", "$H watch rig.log --once",
        "$H diagnose --rig rig/rig.toml --data rig/level_1.csv"}) {
    const auto result = shell(std::string(command) + " > /dev/full");
    EXPECT_EQ(result.status, 2) << command;
    EXPECT_NE(result.errors.find("cannot be written"), std::string::npos) << command << result.errors;
  }
}

TEST_F(Terminal, ALogWithoutAFrameCannotAnswer) {
  workspace_.write("words.log", "no\nframes\n");
  for (const char* command : {"$H decode words.log", "$H decode < words.log", "$H decode --csv words.log",
                              "$H watch words.log --once", "$H watch - < words.log"}) {
    const auto result = shell(command);
    EXPECT_EQ(result.status, 3) << command;
    EXPECT_NE(result.errors.find("no CAN frame"), std::string::npos) << result.errors;
  }
}

// No line is wider than the terminal; name, estimate, interval, unit and status stand at every width.
TEST_F(Terminal, TheTableFitsItsWidth) {
  for (const int width : {60, 70, 80, 200}) {
    const auto result = shell("COLUMNS=" + std::to_string(width) + " $H run");
    ASSERT_EQ(result.status, 0) << result.errors;
    std::istringstream lines(result.output);
    for (std::string line; std::getline(lines, line);)
      EXPECT_TRUE(line.size() <= static_cast<size_t>(width) || line.find("frames:") == 0) << line;
    for (const char* words : {"viscous[1-0]", "estimate", "95 % from", "N s/m", "VALID"})
      EXPECT_NE(result.output.find(words), std::string::npos) << words << result.output;
    EXPECT_EQ(result.output.find("paper   ") != std::string::npos, width >= 80) << result.output;
  }
}

// libmatio brings some thirty libraries along, more than all else that a start loads: only a MAT file asks for it.
TEST_F(Terminal, OnlyAMatFileLoadsItsLibrary) {
  workspace_.write("some.mat", "no MAT file");
  workspace_.write("some.csv", "t_s\n");
  const auto loads = [&](const std::string& arguments) {
    return shell("LD_DEBUG=files $H " + arguments + " 2>&1 | grep -c libmatio").output != "0\n";
  };
  EXPECT_FALSE(loads("--version"));
  EXPECT_FALSE(loads("check --data some.csv"));
  EXPECT_TRUE(loads("check --data some.mat"));
}

// The line that comes later is decoded while the program waits; an interrupt ends it.
TEST_F(Terminal, DecodeFollowsAGrowingLog) {
  workspace_.write("grow.log", "(1.0) can0 701#05\n(1.1) can0 70");
  const auto result = shell(
      "$H decode --csv --follow grow.log > rows & pid=$!; "
      "until grep -q OPERATIONAL rows 2>/dev/null; do sleep 0.01; done; echo '2#04' >> grow.log; "
      "until grep -q STOPPED rows; do sleep 0.01; done; kill $pid; wait $pid; cat rows");
  EXPECT_NE(result.output.find("1.100000,can0,node 2,heartbeat,state,4,,1,STOPPED\n"), std::string::npos)
      << result.output << result.errors;
}

// Every line of every help is at most 80 columns wide, and the meaning of an option continues in its own column.
TEST_F(Terminal, HelpFitsEightyColumns) {
  for (const char* command : {"run", "estimate", "check", "diagnose", "sweep", "decode", "watch", "dbc"}) {
    std::istringstream lines(host_sim({command, "--help"}).output);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80u) << command << ": " << line;
  }
  const std::string help = host_sim({"estimate", "--help"}).output;
  EXPECT_NE(help.find("--frequency"), std::string::npos);
  EXPECT_NE(help.find("\n                              "), std::string::npos) << help;
  // "--node INT:INT in [0 - 7]=0" leaves one blank before its meaning
  const std::string watch = host_sim({"watch", "--help"}).output;
  EXPECT_NE(watch.find("\n                              that is heard\n"), std::string::npos) << watch;
  EXPECT_NE(watch.find("Keys, on a terminal:"), std::string::npos) << watch;
}

}  // namespace

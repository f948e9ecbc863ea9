// The commands of README.md and docs/quickstart.md work as they stand: the blocks marked ```sh are run, one after
// another.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>

#include "tests/host_sim/program_test.hpp"

namespace {

namespace fs = std::filesystem;

// The text of all blocks of a language, "sh" or "python".
std::string blocks(const fs::path& page, const std::string& language) {
  std::ifstream stream(page);
  std::string text;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("```", 0) == 0)
      inside = line == "```" + language;
    else if (inside)
      text += line + "\n";
  }
  EXPECT_FALSE(text.empty()) << page;
  return text;
}

// The text of all ```sh blocks. The two commands that build are left out: they are what runs these tests.
std::string shell_blocks(const fs::path& page) {
  std::ifstream stream(page);
  std::string script = "set -e -o pipefail\n";
  bool inside = false;
  int blocks = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("```", 0) == 0) {
      inside = line == "```sh";
      blocks += inside ? 1 : 0;
    } else if (inside && line != "./host_sim/run.sh" && line != "./tests/run.sh") {
      script += line + "\n";
    }
  }
  EXPECT_GT(blocks, 0) << page;
  return script;
}

class ReadMe : public test_support::ProgramTest {
 protected:
  // What the commands print.
  std::string run_page(const std::string& name) {
    fs::create_directories(workspace_.path() / "build");
    fs::create_directory_symlink(BUILD_DIR, workspace_.path() / "build" / "host");
    const auto result =
        test_support::run_program({"bash", "-c", shell_blocks(fs::path(SOURCE_DIR) / name)}, workspace_.path());
    EXPECT_EQ(result.status, 0) << result.output << result.errors;
    return result.output;
  }
};

TEST_F(ReadMe, CommandsWork) {
  // The rig file of the example is the rig that made the recordings: nothing is missing.
  const std::string printed = run_page("README.md");
  EXPECT_NE(printed.find("none: The rig file explains the measurement"), std::string::npos);
  // What reads the estimates from the log shows name, value, unit, deviation and status of each.
  EXPECT_TRUE(
      std::regex_search(printed, std::regex("estimate +viscous\\[1-2\\] += [0-9.]+ N s/m +std [-0-9.e]+ +VALID")))
      << printed;
  EXPECT_TRUE(fs::exists(workspace_.path() / "page" / "index.html"));
  EXPECT_NE(workspace_.read("rig.dbc").find("BO_ "), std::string::npos);
}

TEST_F(ReadMe, QuickstartWorksAndFindsTheTruthItStates) {
  run_page("docs/quickstart.md");
  EXPECT_NEAR(value(json("result.json"), "viscous[1-0]"), 4.0, 0.08);
  EXPECT_NEAR(value(json("result.json"), "coulomb[1-0]"), 2.0, 0.1);
  EXPECT_TRUE(fs::exists(workspace_.path() / "better.toml"));
}

TEST_F(ReadMe, ThePageOnTheLiveRigWorks) {
  run_page("docs/live.md");
  const std::string rows = workspace_.read("rows.csv");
  EXPECT_NE(rows.find(",estimate,viscous[1-2],"), std::string::npos);
  // Every line of JSON is an object; the first estimate has the columns of the page.
  std::ifstream lines(workspace_.path() / "rows.json");
  bool seen = false;
  for (std::string line; std::getline(lines, line);) {
    const auto row = nlohmann::json::parse(line);
    ASSERT_EQ(row.size(), 9u) << line;
    if (row["frame"] != "estimate" || row["name"] != "viscous[1-2]") continue;
    seen = true;
    EXPECT_EQ(row["unit"], "N s/m");
    EXPECT_TRUE(row["value"].is_number() && row["std"].is_number() && row["time_s"].is_number());
  }
  EXPECT_TRUE(seen);
}

// The plot of the page, with a drawing library that prints what it is to draw in the place of matplotlib.
TEST_F(ReadMe, ThePlotInThreeLinesOfPythonDrawsTheEstimates) {
  run_page("docs/live.md");
  const std::string plot = blocks(fs::path(SOURCE_DIR) / "docs/live.md", "python");
  EXPECT_EQ(std::count(plot.begin(), plot.end(), '\n'), 3);
  workspace_.write("plot.py", plot);
  workspace_.write("matplotlib/__init__.py", "");
  workspace_.write("matplotlib/pyplot.py",
                   "def errorbar(x, y, e):\n  print(len(x) == len(y) == len(e) > 5, round(y[-1], 2))\n"
                   "def show():\n  print('shown')\n");
  const auto result = test_support::run_program({"python3", "plot.py"}, workspace_.path());
  EXPECT_EQ(result.output, "True 6.0\nshown\n") << result.errors;
}

TEST_F(ReadMe, TheDecisionIsTheOneOfThePage) {
  run_page("docs/design_decision.md");
  // The table of the page, and nothing but it.
  const std::string page = [] {
    std::ifstream stream(fs::path(SOURCE_DIR) / "docs/design_decision.md");
    return std::string((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  }();
  std::istringstream designs(workspace_.read("designs.txt"));
  int count = 0;
  for (std::string line; std::getline(designs, line); ++count)
    EXPECT_NE(page.find("|" + line.substr(line.find(':') + 1) + " |"), std::string::npos) << line;
  EXPECT_EQ(count, 4);
  // The table of step 2, line by line.
  const auto estimate =
      host_sim({"estimate", "--rig", "pump/rig.toml", "--data", "pump/level_1.csv", "pump/level_2.csv"});
  std::istringstream printed(estimate.output);
  int rows = 0;
  for (std::string line; std::getline(printed, line);) {
    if (line.find("N s/m") == std::string::npos && line.find(" N ") == std::string::npos) continue;
    EXPECT_NE(page.find("    " + line + "\n"), std::string::npos) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 3);
}

TEST_F(ReadMe, ThePageOnCanWorks) {
  run_page("docs/can_protocol.md");
  EXPECT_NE(workspace_.read("my_rig.dbc").find("SG_ viscous_1_2_std : 32|32@1- (1,0)"), std::string::npos);
}

// The table of the page is what the program prints; renew it with `host_sim run`. Names, truth, paper, unit and status have
// to be the same, estimates and the ends of their intervals within 1e-6 of each other.
TEST_F(ReadMe, ItsTableIsThatOfTheProgram) {
  const auto run = host_sim({"run"});
  ASSERT_EQ(run.status, 0);
  std::ifstream stream(fs::path(SOURCE_DIR) / "README.md");
  std::map<std::string, std::vector<std::string>> rows;
  const auto words_of = [](const std::string& line) {
    std::istringstream input(line);
    return std::vector<std::string>(std::istream_iterator<std::string>(input), {});
  };
  for (std::string line; std::getline(stream, line);) {
    const std::vector<std::string> words = words_of(line);
    if (words.size() > 7 && line.rfind("    ", 0) == 0) rows[words[0]] = words;
  }
  std::istringstream printed(run.output);
  int compared = 0;
  for (std::string line; std::getline(printed, line);) {
    const std::vector<std::string> words = words_of(line);
    if (words.size() < 8 || words[0].find('[') == std::string::npos) continue;
    const std::vector<std::string>& row = rows[words[0]];
    ASSERT_EQ(row.size(), words.size()) << line;
    for (const size_t same : {size_t{1}, size_t{2}, size_t{6}, words.size() - 1})
      EXPECT_EQ(row[same], words[same]) << line;
    for (const size_t near : {size_t{3}, size_t{4}, size_t{5}})
      EXPECT_NEAR(std::stod(row[near]), std::stod(words[near]), 1e-6 * std::abs(std::stod(words[near]))) << line;
    ++compared;
  }
  EXPECT_EQ(compared, 5);
}

// A unit whose condition fails is not tried again: the board's file has to be there first.
TEST_F(ReadMe, TheBoardsFileComesBeforeItsService) {
  for (const char* page : {"README.md", "docs/board.md"}) {
    std::ifstream stream(fs::path(SOURCE_DIR) / page);
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    const size_t file = text.find("board.example.toml /etc/rig_controller/board.toml"),
                 service = text.find("systemctl enable --now systemd-networkd rig_controller");
    ASSERT_NE(service, std::string::npos) << page;
    EXPECT_LT(file, service) << page;
  }
}

// Links between the pages lead somewhere; accuracy, diagnosis and speed are written by tests/run.sh --bench.
TEST_F(ReadMe, LinkedPagesExist) {
  const std::set<std::string> kWrittenByBench = {"accuracy.md", "diagnosis.md", "speed.md"};
  for (const char* page : {"README.md", "docs/quickstart.md", "docs/formats.md", "docs/limits.md", "docs/live.md",
                           "docs/design_decision.md", "docs/CHANGELOG.md", "docs/estimation.md"}) {
    std::ifstream stream(fs::path(SOURCE_DIR) / page);
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    for (size_t at = 0; (at = text.find("](", at)) != std::string::npos; ++at) {
      const std::string target = text.substr(at + 2, text.find(')', at) - at - 2);
      if (kWrittenByBench.count(fs::path(target).filename()) > 0) continue;
      EXPECT_TRUE(fs::exists((fs::path(SOURCE_DIR) / page).parent_path() / target)) << page << " links to " << target;
    }
  }
}

}  // namespace

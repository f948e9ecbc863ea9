// The commands of README.md and docs/quickstart.md work as they stand: the blocks marked ```sh are run, one after
// another.
#include <fstream>

#include "tests/host_sim/program_test.hpp"

namespace {

namespace fs = std::filesystem;

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
  void run_page(const std::string& name) {
    fs::create_directories(workspace_.path() / "build");
    fs::create_directory_symlink(BUILD_DIR, workspace_.path() / "build" / "host");
    const auto result =
        test_support::run_program({"bash", "-c", shell_blocks(fs::path(SOURCE_DIR) / name)}, workspace_.path());
    EXPECT_EQ(result.status, 0) << result.output << result.errors;
  }
};

TEST_F(ReadMe, CommandsWork) {
  run_page("README.md");
  EXPECT_TRUE(fs::exists(workspace_.path() / "page" / "index.html"));
  EXPECT_NE(workspace_.read("rig.dbc").find("BO_ "), std::string::npos);
}

TEST_F(ReadMe, QuickstartWorksAndFindsTheTruthItStates) {
  run_page("docs/quickstart.md");
  EXPECT_NEAR(value(json("result.json"), "viscous[1-0]"), 4.0, 0.08);
  EXPECT_NEAR(value(json("result.json"), "coulomb[1-0]"), 2.0, 0.1);
  EXPECT_TRUE(fs::exists(workspace_.path() / "better.toml"));
}

// Links between the pages lead somewhere; accuracy, diagnosis and speed are written by tests/run.sh --bench.
TEST_F(ReadMe, LinkedPagesExist) {
  const std::set<std::string> kWrittenByBench = {"accuracy.md", "diagnosis.md", "speed.md"};
  for (const char* page : {"README.md", "docs/quickstart.md", "docs/formats.md"}) {
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

// Pages as files: whole or not at all, each picture with its data.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "host_sim/reports/page/report.hpp"
#include "tests/reports/made_up.hpp"
#include "tests/reports/page_parts.hpp"

namespace {

namespace fs = std::filesystem;
using namespace host_sim::reports;
using page_parts::contains;

std::string content(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path).rdbuf();
  return out.str();
}

// A place of this process's own, gone at the end of the test.
class FreshPlace {
 public:
  explicit FreshPlace(const char* name) : path(testing::TempDir() + name + std::to_string(getpid())) {
    fs::remove_all(path);
  }
  ~FreshPlace() { fs::remove_all(path); }
  const fs::path path;
};

TEST(WriteReport, MakesTheFolderAndReplacesAnEarlierPage) {
  const FreshPlace place("report_written");
  const fs::path folder = place.path / "deep";
  write_diagnosis_report(folder.string(), made_up::diagnosis(3000));
  EXPECT_TRUE(contains(content(folder / "index.html"), "cubic stiffness"));
  EXPECT_TRUE(fs::exists(folder / "figures/01_dof_1_displacement_worst_moment.csv"));
  for (const char* own : {"figures/notes.csv", "figures/99_of_the_user.csv"})
    std::ofstream(folder / own) << "not of a page";
  write_run_report(folder.string(), made_up::run(2000));
  EXPECT_TRUE(contains(content(folder / "index.html"), "paper_3dof_random_noise"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);  // the page and figures/
  for (const char* own : {"figures/notes.csv", "figures/99_of_the_user.csv"})
    EXPECT_EQ(content(folder / own), "not of a page") << own;
  EXPECT_FALSE(fs::exists(
      folder / "figures/01_dof_1_displacement_worst_moment.csv"));  // a run's page begins with another picture
}

// The user's files are named as a page's are; the page before is not ours, whatever it lists.
TEST(WriteReport, FilesOfNoEarlierPageStay) {
  const FreshPlace place("report_others");
  fs::create_directories(place.path / "figures");
  for (const char* own : {"figures/01_force.csv", "02_data.csv"}) std::ofstream(place.path / own) << "measured";
  std::ofstream(place.path / "index.html")
      << "<html><meta name=\"host_sim-figures\" content=\"../02_data.csv x\"></html>";
  write_run_report(place.path.string(), made_up::run(2000));
  for (const char* own : {"figures/01_force.csv", "02_data.csv"})
    EXPECT_EQ(content(place.path / own), "measured") << own;
}

// Every picture of the page has its file, and no file is of another page.
TEST(WriteReport, EveryPictureHasItsData) {
  const FreshPlace place("report_figures");
  write_diagnosis_report(place.path.string(), made_up::diagnosis(3000));
  const std::string page = content(place.path / "index.html");
  size_t pictures = 0;
  for (size_t at = page.find("<figure>"); at != std::string::npos; at = page.find("<figure>", at + 1)) ++pictures;
  ASSERT_GT(pictures, 5u);
  const fs::path figures = place.path / "figures";
  EXPECT_EQ(static_cast<size_t>(std::distance(fs::directory_iterator(figures), fs::directory_iterator())), pictures);
  for (const auto& entry : fs::directory_iterator(figures)) {
    const std::string table = content(entry.path());
    EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 1) << entry.path();
  }
}

TEST(WriteReport, AFileInTheWayIsNamed) {
  const FreshPlace place("report_in_the_way");
  const fs::path& folder = place.path;
  std::ofstream(folder) << "not a folder";
  try {
    write_run_report(folder.string(), made_up::run(2000));
    FAIL() << "expected an error";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), folder.string())) << error.what();
  }
  EXPECT_EQ(content(folder), "not a folder");
}

}  // namespace

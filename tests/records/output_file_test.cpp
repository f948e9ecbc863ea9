// A result file appears whole or not at all.
#include "host_sim/records/files/output_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "host_sim/records/files/file_content.hpp"

namespace {

namespace fs = std::filesystem;

class OutputFileTest : public ::testing::Test {
 protected:
  OutputFileTest() : folder_(fs::temp_directory_path() / ("output_file_test_" + std::to_string(::getpid()))) {
    fs::create_directory(folder_);
  }
  ~OutputFileTest() override { fs::remove_all(folder_); }
  size_t entries() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST_F(OutputFileTest, HasItsNameOnlyAfterCommit) {
  const std::string path = folder_ / "result.json";
  host_sim::OutputFile file(path);
  file.write("whole");
  EXPECT_FALSE(fs::exists(path));
  file.commit();
  EXPECT_EQ(host_sim::read_whole_file(path), "whole");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, WithoutCommitTheOldContentStaysAndNothingElse) {
  const std::string path = folder_ / "result.json";
  host_sim::write_output_file(path, "old");
  {
    host_sim::OutputFile file(path);
    file.write("half");
  }
  EXPECT_EQ(host_sim::read_whole_file(path), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(OutputFileTest, AMissingFolderIsAnErrorThatNamesThePath) {
  try {
    host_sim::OutputFile file(folder_ / "nowhere" / "result.json");
    FAIL() << "opened";
  } catch (const host_sim::OutputError& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere/result.json"), std::string::npos);
  }
}

TEST_F(OutputFileTest, ADeviceKeepsItsPlace) {
  host_sim::write_output_file("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace

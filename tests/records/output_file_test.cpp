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

// A link stays one: what it leads to is written, also where that is not there yet.
TEST_F(OutputFileTest, ALinkKeepsItsPlace) {
  namespace fs = std::filesystem;
  fs::create_directory(folder_ / "kept");
  for (const char* target : {"kept/old.json", "kept/new.json"}) {
    if (std::string(target) == "kept/old.json") host_sim::write_output_file((folder_ / target).string(), "old");
    fs::create_symlink(target, folder_ / "link.json");
    host_sim::write_output_file((folder_ / "link.json").string(), "new content");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link.json")) << target;
    EXPECT_EQ(fs::file_size(folder_ / target), 11u) << target;
    fs::remove(folder_ / "link.json");
  }
}

TEST_F(OutputFileTest, TwoResultsInOneFileAreRefused) {
  const host_sim::OutputFile one((folder_ / "result.json").string());
  for (const char* name : {"result.json", "./result.json"}) try {
      const host_sim::OutputFile other((folder_ / name).string());
      ADD_FAILURE() << name << " was taken twice";
    } catch (const host_sim::OutputError& error) {
      EXPECT_NE(std::string(error.what()).find("is to hold two results of this command"), std::string::npos)
          << error.what();
    }
}

TEST_F(OutputFileTest, ADeviceKeepsItsPlace) {
  host_sim::write_output_file("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace

// Runs a program of the build as a user would, in a folder of its own.
#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace test_support {

struct ProgramResult {
  int status = -1;  // exit status; 128 + signal where a signal ended it
  std::string output, errors;
  double seconds = 0.0;
};

// input is its stdin. Output and errors are kept apart.
ProgramResult run_program(const std::vector<std::string>& command, const std::filesystem::path& folder,
                          const std::string& input = "");

// An empty folder that is gone afterwards.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  const std::filesystem::path& path() const { return path_; }
  void write(const std::string& name, const std::string& content) const;
  std::string read(const std::string& name) const;
  std::set<std::string> entries() const;  // names, also of files in folders below

 private:
  std::filesystem::path path_;
};

// RIG_SHARED_DIR, or ../shared beside the source tree; empty where it is absent.
std::filesystem::path shared_folder();

}  // namespace test_support

// A result file that appears whole or not at all: written under a temporary name, renamed by commit().
#pragma once
#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace host_sim {

class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class OutputFile {
 public:
  explicit OutputFile(std::string path);  // throws OutputError where the folder does not take a file
  ~OutputFile();                          // without commit() nothing stays
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);  // throws OutputError
  void commit();                       // throws OutputError; the file has its name only afterwards
  const std::string& path() const { return path_; }

 private:
  std::string path_, place_, temporary_;  // place: behind links
  std::FILE* stream_ = nullptr;
};

// From now on a signal that ends the program (interrupt, termination, hang-up, broken pipe) removes the temporary files
// first.
void remove_temporary_files_on_signals();

// The whole file at once.
void write_output_file(const std::string& path, std::string_view content);

}  // namespace host_sim

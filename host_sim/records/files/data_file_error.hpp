// A data file that cannot be used: where, what is there, and what was expected.
#pragma once
#include <stdexcept>
#include <string>

namespace host_sim {

class DataFileError : public std::runtime_error {
 public:
  // error_line 0: the fault has no line (the file is missing, for instance).
  DataFileError(std::string error_file, size_t error_line, std::string error_problem)
      : std::runtime_error(error_file + (error_line > 0 ? ":" + std::to_string(error_line) : "") + ": " +
                           error_problem),
        file(std::move(error_file)),
        line(error_line),
        problem(std::move(error_problem)) {}

  std::string file;
  size_t line;
  std::string problem;
};

}  // namespace host_sim

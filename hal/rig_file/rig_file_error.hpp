// A rig file that cannot be used: where, what is there, and what was expected.
#pragma once
#include <stdexcept>
#include <string>

namespace rig_file {

class RigFileError : public std::runtime_error {
 public:
  // line 0: the fault has no line (the file is missing, for instance); key may be empty.
  RigFileError(std::string error_file, unsigned error_line, std::string error_key, std::string error_problem)
      : std::runtime_error(message(error_file, error_line, error_key, error_problem)),
        file(std::move(error_file)),
        line(error_line),
        key(std::move(error_key)),
        problem(std::move(error_problem)) {}

  std::string file;
  unsigned line;
  std::string key;
  std::string problem;  // "... , expected ..."

 private:
  static std::string message(const std::string& f, unsigned l, const std::string& k, const std::string& p) {
    std::string text = f;
    if (l > 0) text += ":" + std::to_string(l);
    if (!k.empty()) text += ": " + k;
    return text + ": " + p;
  }
};

}  // namespace rig_file

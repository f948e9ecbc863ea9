// Where text for people goes: stdout, unless a result is asked for there ("-"); then stderr.
#pragma once
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>

#include "host_sim/programs/shared/failures.hpp"
#include "host_sim/records/files/output_file.hpp"

namespace host_sim {

// Throws OutputError where the text does not go out, as on a full disk.
inline void write_text(std::FILE* stream, const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (!written || std::fflush(stream) != 0)
    throw OutputError(std::string(stream == stdout ? "stdout" : "stderr") +
                      ": cannot be written, expected a reader and a disk with room");
}

// A result for which the user named a file, or "-" for stdout, or nothing. Opened at once, so that a path that cannot
// be written is known before the work; the content appears when it is complete.
class ResultTarget {
 public:
  explicit ResultTarget(const std::string& path) : to_stdout_(path == "-") {
    if (!path.empty() && !to_stdout_) file_ = std::make_unique<OutputFile>(path);
  }
  bool wanted() const { return to_stdout_ || file_ != nullptr; }
  bool to_stdout() const { return to_stdout_; }
  void deliver(const std::string& content) {
    if (file_ != nullptr) {
      file_->write(content);
      file_->commit();
    } else if (to_stdout_) {
      write_text(stdout, content);
    }
  }

 private:
  bool to_stdout_;
  std::unique_ptr<OutputFile> file_;
};

// The stream for people, given the results that may go to stdout. Two of them there would mix: UsageError.
inline std::FILE* human_stream(const ResultTarget& a, const ResultTarget& b) {
  if (a.to_stdout() && b.to_stdout()) throw UsageError("two results are to go to stdout, expected \"-\" once");
  return a.to_stdout() || b.to_stdout() ? stderr : stdout;
}

// At the end of every command: what it printed has been taken. A full disk shows only now, when the buffer goes out.
inline void finish_stdout() {
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw OutputError("stdout: cannot be written, expected a reader, or a disk with room");
}

}  // namespace host_sim

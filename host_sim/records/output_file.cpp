#include "host_sim/records/output_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace host_sim {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw OutputError(path + ": cannot be " + what + " (" + std::strerror(errno) +
                    "), expected a writable folder with room");
}

// A pipe or a device keeps its place: renaming would replace it.
bool is_special(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (!is_special(path_)) temporary_ = path_ + ".part" + std::to_string(::getpid());
  stream_ = std::fopen(temporary_.empty() ? path_.c_str() : temporary_.c_str(), "wb");
  if (stream_ == nullptr) fail(path_, "written");
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail(path_, "written");
}

void OutputFile::commit() {
  std::FILE* const stream = stream_;
  stream_ = nullptr;
  const bool flushed = std::fflush(stream) == 0;
  const bool closed = std::fclose(stream) == 0;
  if (!flushed || !closed) fail(path_, "written");
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, "renamed");
  temporary_.clear();
}

void write_output_file(const std::string& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace host_sim

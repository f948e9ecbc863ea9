#include "host_sim/records/files/output_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

#include "host_sim/records/files/input_files.hpp"

namespace host_sim {
namespace {

[[noreturn]] void fail(const std::string& path, const char* what) {
  throw OutputError(path + ": cannot be " + what + " (" + std::strerror(errno) +
                    "), expected a writable folder with room");
}

// Names of temporary files where a signal handler can read them: no allocation, no locks.
constexpr int kMostFiles = 16;
constexpr size_t kLongestPath = 4096;
char temporary_names[kMostFiles][kLongestPath];

void remember(const std::string& name) {
  if (name.size() >= kLongestPath) return;
  for (auto& slot : temporary_names)
    if (slot[0] == '\0') {
      std::memcpy(slot, name.c_str(), name.size() + 1);
      return;
    }
}

void forget(const std::string& name) {
  for (auto& slot : temporary_names)
    if (name == slot) slot[0] = '\0';
}

extern "C" void remove_temporary_files(int signal) {
  for (const auto& slot : temporary_names)
    if (slot[0] != '\0') ::unlink(slot);
  ::raise(signal);  // its default action again: SA_RESETHAND
}

// A pipe or a device keeps its place: renaming would replace it.
bool is_special(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

// What a link leads to, whether it is there or not: the link keeps its place.
std::string behind_links(const std::string& path) {
  namespace fs = std::filesystem;
  constexpr int kMostLinks = 40;
  std::error_code failure;
  fs::path place = path;
  for (int i = 0; i < kMostLinks && fs::is_symlink(place, failure); ++i) {
    const fs::path target = fs::read_symlink(place, failure);
    if (failure) break;
    place = place.parent_path() / target;  // an absolute target alone
  }
  return place.string();
}

bool is_open_output(const std::string& temporary) {
  struct stat one {
  }, other{};
  if (temporary.empty() || ::stat(temporary.c_str(), &one) != 0) return false;
  for (const auto& slot : temporary_names)
    if (slot[0] != '\0' && ::stat(slot, &other) == 0 && one.st_dev == other.st_dev && one.st_ino == other.st_ino)
      return true;
  return false;
}

void refuse_input(const std::string& path) {
  if (is_input_file(path)) throw OutputError(path + ": is read by this command, expected another file for its result");
}

}  // namespace

OutputFile::OutputFile(std::string path) : path_(std::move(path)), place_(behind_links(path_)) {
  refuse_input(path_);
  if (!is_special(path_)) temporary_ = place_ + ".part" + std::to_string(::getpid());
  if (is_open_output(temporary_))
    throw OutputError(path_ + ": is to hold two results of this command, expected a file for each");
  remember(temporary_);  // before it is there: a signal may come between
  stream_ = std::fopen(temporary_.empty() ? path_.c_str() : temporary_.c_str(), "wb");
  if (stream_ != nullptr) return;
  const int reason = errno;
  forget(temporary_);
  errno = reason;
  fail(path_, "written");
}

OutputFile::~OutputFile() {
  if (stream_ != nullptr) std::fclose(stream_);
  if (temporary_.empty()) return;
  std::remove(temporary_.c_str());
  forget(temporary_);
}

void OutputFile::write(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stream_) != bytes.size()) fail(path_, "written");
}

void OutputFile::commit() {
  refuse_input(path_);  // it may have been read since
  std::FILE* const stream = stream_;
  stream_ = nullptr;
  const bool flushed = std::fflush(stream) == 0;
  const bool closed = std::fclose(stream) == 0;
  if (!flushed || !closed) fail(path_, "written");
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), place_.c_str()) != 0) fail(path_, "renamed");
  forget(temporary_);
  temporary_.clear();
}

void remove_temporary_files_on_signals() {
  struct sigaction action {};
  action.sa_handler = remove_temporary_files;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) ::sigaction(signal, &action, nullptr);
}

void write_output_file(const std::string& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace host_sim

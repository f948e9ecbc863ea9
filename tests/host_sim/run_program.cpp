#include "tests/host_sim/run_program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace test_support {
namespace fs = std::filesystem;
namespace {

std::string content_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

void redirect(const fs::path& path, int flags, int descriptor) {
  const int opened = ::open(path.c_str(), flags, 0600);
  if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(126);
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& command, const fs::path& folder, const std::string& input) {
  Workspace streams;  // files instead of pipes: no reader is needed while the program runs
  streams.write("in", input);
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child == 0) {
    redirect(streams.path() / "in", O_RDONLY, 0);
    redirect(streams.path() / "out", O_WRONLY | O_CREAT, 1);
    redirect(streams.path() / "err", O_WRONLY | O_CREAT, 2);
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    std::vector<char*> arguments;
    for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ProgramResult result;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  result.output = content_of(streams.path() / "out");
  result.errors = content_of(streams.path() / "err");
  return result;
}

Workspace::Workspace() {
  std::string name = (fs::temp_directory_path() / "rig_test_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

Workspace::~Workspace() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void Workspace::write(const std::string& name, const std::string& content) const {
  fs::create_directories((path_ / name).parent_path());
  std::ofstream(path_ / name, std::ios::binary) << content;
}

std::string Workspace::read(const std::string& name) const { return content_of(path_ / name); }

std::set<std::string> Workspace::entries() const {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(path_))
    if (!entry.is_directory()) names.insert(fs::relative(entry.path(), path_).string());
  return names;
}

fs::path shared_folder() {
  const char* given = std::getenv("RIG_SHARED_DIR");
  const fs::path folder = given != nullptr ? fs::path(given) : fs::path(SOURCE_DIR) / ".." / "shared";
  return fs::exists(folder / "measured") ? fs::canonical(folder) : fs::path();
}

}  // namespace test_support

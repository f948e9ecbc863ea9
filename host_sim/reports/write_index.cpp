// Puts a page in its place all at once.
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "host_sim/reports/page.hpp"

namespace host_sim::reports {

void write_index(const std::string& directory, const std::string& content) {
  namespace fs = std::filesystem;
  std::error_code failure;
  const bool made = fs::create_directories(directory, failure);
  if (failure || !fs::is_directory(directory))
    throw std::runtime_error(directory + ": cannot make this folder for the report" +
                             (failure ? " (" + failure.message() + ")" : std::string()));
  const fs::path target = fs::path(directory) / "index.html";
  const fs::path part = fs::path(directory) / (".index.html." + std::to_string(getpid()));
  errno = 0;
  bool written = false;
  {
    std::ofstream file(part, std::ios::binary);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.flush();
    written = file.good();
  }
  const std::string reason = errno ? std::strerror(errno) : "not all of it was written";
  if (written) fs::rename(part, target, failure);
  if (written && !failure) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  if (made) fs::remove(directory, ignored);
  throw std::runtime_error(target.string() + ": cannot write the report (" + (failure ? failure.message() : reason) +
                           ")");
}

}  // namespace host_sim::reports

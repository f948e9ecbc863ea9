#include "hal/linux/board/run_marker.hpp"

#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

#include "hal/linux/system/file_descriptor.hpp"

namespace board {

bool RunMarker::begin(const std::string& folder) {
  path_ = folder.empty() ? "" : folder + "/running";
  if (path_.empty()) return false;
  const hal::FileDescriptor made(::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
  return !made && errno == EEXIST;
}

void RunMarker::end_well() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

std::string runtime_folder() {
  const char* const given = std::getenv("RUNTIME_DIRECTORY");
  if (given != nullptr && *given != '\0') return given;
  const std::string own = "/run/rig_controller";
  return ::mkdir(own.c_str(), 0755) == 0 || errno == EEXIST ? own : "";
}

}  // namespace board

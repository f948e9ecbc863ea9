#include "host_sim/records/files/input_files.hpp"

#include <sys/stat.h>

#include <mutex>
#include <set>
#include <utility>

namespace host_sim {
namespace {

using Identity = std::pair<dev_t, ino_t>;
std::mutex guard;
std::set<Identity> files;

bool identify(const std::string& path, Identity& identity) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
  identity = {status.st_dev, status.st_ino};
  return true;
}

}  // namespace

void note_input_file(const std::string& path) {
  Identity identity;
  if (!identify(path, identity)) return;
  const std::lock_guard<std::mutex> lock(guard);
  files.insert(identity);
}

bool is_input_file(const std::string& path) {
  Identity identity;
  if (!identify(path, identity)) return false;
  const std::lock_guard<std::mutex> lock(guard);
  return files.count(identity) > 0;
}

}  // namespace host_sim

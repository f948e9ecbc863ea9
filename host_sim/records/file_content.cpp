#include "host_sim/records/file_content.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "host_sim/records/record_reader.hpp"

namespace host_sim {

FileContent::FileContent(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (descriptor >= 0 && ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
    void* const pages = ::mmap(nullptr, static_cast<size_t>(status.st_size), PROT_READ, MAP_PRIVATE, descriptor, 0);
    if (pages != MAP_FAILED) {
      mapped_ = pages;
      text_ = std::string_view(static_cast<const char*>(pages), static_cast<size_t>(status.st_size));
      ::madvise(pages, text_.size(), MADV_SEQUENTIAL);
    }
  }
  if (descriptor >= 0) ::close(descriptor);
  if (mapped_ != nullptr) return;
  copy_ = read_whole_file(path);  // pipes, empty files; says what is wrong with others
  text_ = copy_;
}

FileContent::~FileContent() {
  if (mapped_ != nullptr) ::munmap(mapped_, text_.size());
}

}  // namespace host_sim

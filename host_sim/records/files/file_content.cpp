#include "host_sim/records/files/file_content.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "host_sim/records/files/data_file_error.hpp"

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

std::string read_whole_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) throw DataFileError(path, 0, "cannot be opened, expected a readable data file");
  std::string content;
  char chunk[1 << 16];
  for (size_t got = 0; (got = std::fread(chunk, 1, sizeof chunk, file.get())) > 0;) content.append(chunk, got);
  if (std::ferror(file.get()) != 0)
    throw DataFileError(path, 0, "cannot be read, expected a readable data file, not a folder");
  return content;
}

}  // namespace host_sim

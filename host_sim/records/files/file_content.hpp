// The bytes of a file without a copy: mapped where the system can, else read.
#pragma once
#include <string>
#include <string_view>

namespace host_sim {

class FileContent {
 public:
  explicit FileContent(const std::string& path);  // throws DataFileError where it cannot be read
  ~FileContent();
  FileContent(const FileContent&) = delete;
  FileContent& operator=(const FileContent&) = delete;
  std::string_view text() const { return text_; }

 private:
  std::string copy_;
  void* mapped_ = nullptr;
  std::string_view text_;
};

// The whole file. Throws DataFileError where it cannot be read.
std::string read_whole_file(const std::string& path);

}  // namespace host_sim

// File operations on a folder of a real file system.
#pragma once
#include <string>

#include "hal/linux/store/file_operations.hpp"
#include "hal/linux/system/file_descriptor.hpp"

namespace hal {

class PosixFileOperations final : public FileOperations {
 public:
  // Makes the folder where it is missing. Empty where it worked, else what is wrong.
  std::string open(const std::string& folder);

  bool create(const char* name) override;
  bool write(const uint8_t* bytes, size_t size) override;
  bool sync_file() override;
  bool close() override;
  bool rename(const char* from, const char* to) override;
  bool sync_folder() override;
  size_t read(const char* name, uint8_t* bytes, size_t capacity) override;

 private:
  FileDescriptor folder_;
  FileDescriptor file_;
};

}  // namespace hal

// The few operations of a file system that the configuration store rests on, small enough to be faked with power cuts.
//
// What may be relied on after a power loss (and what the fake grants, no more): the bytes of a file after sync_file()
// on it, and the names in the folder after sync_folder(). Everything later may be there, partly there or missing.
#pragma once
#include <cstddef>
#include <cstdint>

namespace hal {

class FileOperations {
 public:
  // One file is open for writing at a time. Names are plain, inside the store's folder.
  virtual bool create(const char* name) = 0;  // empty, replacing an earlier file of that name
  virtual bool write(const uint8_t* bytes, size_t size) = 0;
  virtual bool sync_file() = 0;
  virtual bool close() = 0;
  virtual bool rename(const char* from, const char* to) = 0;  // replaces `to`
  virtual bool sync_folder() = 0;
  // Number of bytes read, 0 where there is no such file or it is longer than capacity.
  virtual size_t read(const char* name, uint8_t* bytes, size_t capacity) = 0;

 protected:
  ~FileOperations() = default;
};

}  // namespace hal

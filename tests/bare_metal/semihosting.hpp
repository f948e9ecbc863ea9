// What a debugger (or an emulator) does for a program without an operating system: files of the PC, text, the end.
#pragma once
#include <cstddef>
#include <cstdint>

namespace semihosting {

[[noreturn]] void leave(bool well);

// Words of the program's command line after its own name; at most `capacity` characters with the end.
bool command_line(char* text, size_t capacity);

class File {
 public:
  explicit File(const char* path);  // for reading
  bool open() const { return handle_ >= 0; }
  size_t read(uint8_t* bytes, size_t size);  // the number read; less than size at the end

 private:
  int handle_;
};

void print(const char* text, size_t size);

}  // namespace semihosting

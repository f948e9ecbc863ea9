// The same on a machine with an operating system: script_host SCRIPT [plain]
#include <cstdio>
#include <cstring>

#include "tests/bare_metal/script.hpp"

namespace {

class ScriptFile final : public bare_metal::Bytes {
 public:
  explicit ScriptFile(const char* path) : file_(std::fopen(path, "rb")) {}
  size_t read(uint8_t* bytes, size_t size) override { return file_ ? std::fread(bytes, 1, size, file_) : 0; }

 private:
  std::FILE* file_;
};

class Console final : public bare_metal::Text {
 public:
  void print(const char* text, size_t size) override { std::fwrite(text, 1, size, stdout); }
};

class NoCounter final : public bare_metal::WorkCounter {
 public:
  uint32_t now() override { return 0; }
};

}  // namespace

int main(int count, char** words) {
  if (count < 2) return 2;
  static ScriptFile file(words[1]);
  static Console console;
  static NoCounter counter;
  return bare_metal::run_script(file, console, counter, count > 2 && std::strcmp(words[2], "plain") == 0 ? 1 : 3) ? 0
                                                                                                                  : 1;
}

// The same on a machine with an operating system: script_host SCRIPT [plain] [untested] [frames]
#include <cstdio>

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

int main(int count, char** arguments) {
  if (count < 2) return 2;
  static ScriptFile file(arguments[1]);
  static Console console;
  static NoCounter counter;
  bare_metal::Words words;
  for (int n = 2; n < count; ++n) {
    const bare_metal::Words more = bare_metal::read_words(arguments[n]);
    words.plain = words.plain || more.plain;
    words.untested = words.untested || more.untested;
    words.frames = words.frames || more.frames;
    words.open = words.open || more.open;
    words.sliced = words.sliced || more.sliced;
  }
  return bare_metal::run_script(file, console, counter, words) ? 0 : 1;
}

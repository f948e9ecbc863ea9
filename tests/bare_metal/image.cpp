// The program on the emulated microcontroller: command line "SCRIPT [plain] [untested] [frames]". The work counter is the board's 25 MHz
// timer: with the emulator's -icount shift=6 an instruction takes 64 ns, 1.6 ticks.
#include "tests/bare_metal/script.hpp"
#include "tests/bare_metal/semihosting.hpp"

namespace {

class ScriptFile final : public bare_metal::Bytes {
 public:
  explicit ScriptFile(const char* path) : file_(path) {}
  bool open() const { return file_.open(); }
  size_t read(uint8_t* bytes, size_t size) override { return file_.read(bytes, size); }

 private:
  semihosting::File file_;
};

class Console final : public bare_metal::Text {
 public:
  void print(const char* text, size_t size) override { semihosting::print(text, size); }
};

class Timer final : public bare_metal::WorkCounter {
 public:
  Timer() {  // counts down from 2^32 - 1 and around
    registers()[2] = registers()[1] = 0xffffffffu;
    registers()[0] = 1;
  }
  uint32_t now() override { return 0 - registers()[1]; }

 private:
  static volatile uint32_t* registers() { return reinterpret_cast<volatile uint32_t*>(0x40000000u); }
};

}  // namespace

int main() {
  static char path[256];
  if (!semihosting::command_line(path, sizeof path)) return 1;
  bare_metal::Words words;
  for (char* c = path; *c != 0; ++c)
    if (*c == ' ') {
      *c = 0;
      words = bare_metal::read_words(c + 1);
      break;
    }
  static ScriptFile file(path);
  static Console console;
  static Timer timer;
  return file.open() && bare_metal::run_script(file, console, timer, words) ? 0 : 1;
}

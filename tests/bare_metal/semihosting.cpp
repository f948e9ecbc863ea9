#include "tests/bare_metal/semihosting.hpp"

namespace semihosting {
namespace {

constexpr int kOpen = 0x01, kWrite = 0x05, kRead = 0x06, kGetCommandLine = 0x15, kExit = 0x18;
constexpr uintptr_t kApplicationExit = 0x20026, kRunTimeError = 0x20023;

int call(int operation, uintptr_t argument) {
  register int r0 asm("r0") = operation;
  register uintptr_t r1 asm("r1") = argument;
  asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
}

size_t length(const char* text) {
  size_t n = 0;
  while (text[n] != 0) ++n;
  return n;
}

int open(const char* path, uintptr_t mode) {
  const uintptr_t arguments[3] = {reinterpret_cast<uintptr_t>(path), mode, length(path)};
  return call(kOpen, reinterpret_cast<uintptr_t>(arguments));
}

}  // namespace

void leave(bool well) {
  call(kExit, well ? kApplicationExit : kRunTimeError);
  for (;;) {
  }
}

bool command_line(char* text, size_t capacity) {
  uintptr_t arguments[2] = {reinterpret_cast<uintptr_t>(text), capacity};
  if (call(kGetCommandLine, reinterpret_cast<uintptr_t>(arguments)) != 0) return false;
  size_t word = 0;  // the first word is the program itself
  while (text[word] != 0 && text[word] != ' ') ++word;
  if (text[word] == ' ') ++word;
  size_t to = 0;
  while (text[word] != 0) text[to++] = text[word++];
  text[to] = 0;
  return true;
}

File::File(const char* path) : handle_(semihosting::open(path, 1)) {}  // 1: "rb"

size_t File::read(uint8_t* bytes, size_t size) {
  const uintptr_t arguments[3] = {static_cast<uintptr_t>(handle_), reinterpret_cast<uintptr_t>(bytes), size};
  return size - static_cast<size_t>(call(kRead, reinterpret_cast<uintptr_t>(arguments)));
}

void print(const char* text, size_t size) {
  static const int console = semihosting::open(":tt", 4);  // 4: "w"
  const uintptr_t arguments[3] = {static_cast<uintptr_t>(console), reinterpret_cast<uintptr_t>(text), size};
  call(kWrite, reinterpret_cast<uintptr_t>(arguments));
}

}  // namespace semihosting

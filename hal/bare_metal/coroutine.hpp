// A second line of execution with a stack of its own that is entered and left at will: what a processor without an operating
// system needs to hold a long calculation between two samples. coroutine_cortex_m.cpp does it with some twenty instructions,
// coroutine_ucontext.cpp where there is an operating system, for tests.
//
// The registers of a floating-point unit are not kept: the core does not use them.
#pragma once
#include <cstddef>
#include <cstdint>

namespace hal {

class Coroutine {
 public:
  // body(argument) is entered by the first resume() and must not return. stack: its own, aligned to 8 bytes, outlives this.
  Coroutine(uint8_t* stack, size_t size, void (*body)(void*), void* argument);
  Coroutine(const Coroutine&) = delete;
  Coroutine& operator=(const Coroutine&) = delete;

  void resume();  // from outside: goes on in the body, until it yields
  void yield();   // from inside: goes on outside, until the next resume()

 private:
  void* inside_ = nullptr;  // where it goes on
  void* outside_ = nullptr;
};

}  // namespace hal

// For tests on a machine with an operating system.
#include <ucontext.h>

#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

#include "hal/bare_metal/coroutine.hpp"

namespace hal {
namespace {

struct Contexts {  // at the beginning of the stack
  ucontext_t inside, outside;
  void (*body)(void*);
  void* argument;
};

// makecontext() hands over integers.
void enter(unsigned high, unsigned low) {
  const auto address = static_cast<uintptr_t>((uint64_t{high} << 32) | low);
  const Contexts* contexts = nullptr;
  std::memcpy(&contexts, &address, sizeof address);
  contexts->body(contexts->argument);
  std::abort();
}

}  // namespace

Coroutine::Coroutine(uint8_t* stack, size_t size, void (*body)(void*), void* argument) {
  void* first = stack;
  size_t left = size;
  if (std::align(alignof(Contexts), sizeof(Contexts), first, left) == nullptr) std::abort();
  auto* contexts = new (first) Contexts;
  contexts->body = body;
  contexts->argument = argument;
  getcontext(&contexts->inside);
  const size_t used = size - left + sizeof(Contexts);
  contexts->inside.uc_stack.ss_sp = stack + used;
  contexts->inside.uc_stack.ss_size = size - used;
  contexts->inside.uc_link = nullptr;
  const auto address = static_cast<uint64_t>(reinterpret_cast<uintptr_t>(first));
  makecontext(&contexts->inside, reinterpret_cast<void (*)()>(&enter), 2, static_cast<unsigned>(address >> 32),
              static_cast<unsigned>(address));
  inside_ = contexts;
}

void Coroutine::resume() {
  auto* contexts = static_cast<Contexts*>(inside_);
  swapcontext(&contexts->outside, &contexts->inside);
}

void Coroutine::yield() {
  auto* contexts = static_cast<Contexts*>(inside_);
  swapcontext(&contexts->inside, &contexts->outside);
}

}  // namespace hal

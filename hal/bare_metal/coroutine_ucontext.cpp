// For tests on a machine with an operating system.
#include <ucontext.h>

#include <cstdlib>
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
  const auto* contexts = reinterpret_cast<const Contexts*>(address);
  contexts->body(contexts->argument);
  std::abort();
}

}  // namespace

Coroutine::Coroutine(uint8_t* stack, size_t size, void (*body)(void*), void* argument) {
  constexpr size_t kAlign = alignof(Contexts);
  const auto first = (reinterpret_cast<uintptr_t>(stack) + kAlign - 1) / kAlign * kAlign;
  auto* contexts = new (reinterpret_cast<void*>(first)) Contexts;
  contexts->body = body;
  contexts->argument = argument;
  getcontext(&contexts->inside);
  const uintptr_t used = first + sizeof(Contexts) - reinterpret_cast<uintptr_t>(stack);
  contexts->inside.uc_stack.ss_sp = stack + used;
  contexts->inside.uc_stack.ss_size = size - used;
  contexts->inside.uc_link = nullptr;
  const auto address = static_cast<uint64_t>(first);
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

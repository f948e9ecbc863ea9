// For Cortex-M0+ to M7: instructions that all of them have.
#include "hal/bare_metal/coroutine.hpp"

extern "C" {
// Keeps what a called function has to keep on the stack, that stack's place in *from, and takes up the other one.
void hal_switch_stack(void** from, void* to);
void hal_first_entry();
}

asm(R"(
  .syntax unified
  .text
  .thumb
  .align 2
  .global hal_switch_stack
  .type hal_switch_stack, %function
  .thumb_func
hal_switch_stack:
  push {r4-r7, lr}
  mov r4, r8
  mov r5, r9
  mov r6, r10
  mov r7, r11
  push {r4-r7}
  mov r4, sp
  str r4, [r0]
  mov sp, r1
  pop {r4-r7}
  mov r8, r4
  mov r9, r5
  mov r10, r6
  mov r11, r7
  pop {r4-r7, pc}

  .align 2
  .global hal_first_entry
  .type hal_first_entry, %function
  .thumb_func
hal_first_entry:
  mov r0, r4
  blx r5
  b .
)");

namespace hal {

Coroutine::Coroutine(uint8_t* stack, size_t size, void (*body)(void*), void* argument) {
  // What hal_switch_stack takes from a stack: r8 to r11, r4 to r7, and where it goes on.
  auto* top = reinterpret_cast<uint32_t*>(stack + size / 8 * 8);
  uint32_t* frame = top - 9;
  for (int i = 0; i < 9; ++i) frame[i] = 0;
  frame[4] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(argument));
  frame[5] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(body));
  frame[8] = static_cast<uint32_t>(reinterpret_cast<uintptr_t>(&hal_first_entry));
  inside_ = frame;
}

void Coroutine::resume() { hal_switch_stack(&outside_, inside_); }
void Coroutine::yield() { hal_switch_stack(&inside_, outside_); }

}  // namespace hal

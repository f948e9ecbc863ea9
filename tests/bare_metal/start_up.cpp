// Start of a program on a Cortex-M without an operating system: the vector table, memory, constructors, main, and an end
// that the debugger (or emulator) sees.
#include <cstdint>

#include "tests/bare_metal/semihosting.hpp"

extern "C" {
extern uint32_t image_data_load, image_data_begin, image_data_end, image_bss_begin, image_bss_end, image_stack_end;
extern void (*image_constructors_begin[])();
extern void (*image_constructors_end[])();
int main();
void* __dso_handle = nullptr;
int __aeabi_atexit(void*, void (*)(void*), void*) { return 0; }  // the program never ends: nothing is taken down

[[noreturn]] void reset_handler() {
  const uint32_t* from = &image_data_load;
  for (uint32_t* to = &image_data_begin; to < &image_data_end;) *to++ = *from++;
  for (uint32_t* to = &image_bss_begin; to < &image_bss_end;) *to++ = 0;
  for (void (**constructor)() = image_constructors_begin; constructor < image_constructors_end; ++constructor)
    (*constructor)();
  semihosting::leave(main() == 0);
}

[[noreturn]] void fault_handler() { semihosting::leave(false); }

[[gnu::section(".vectors"), gnu::used]] void (*const vectors[16])() = {reinterpret_cast<void (*)()>(&image_stack_end),
                                                                       reset_handler,
                                                                       fault_handler,  // NMI
                                                                       fault_handler,  // hard fault
                                                                       fault_handler,
                                                                       fault_handler,
                                                                       fault_handler,
                                                                       nullptr,
                                                                       nullptr,
                                                                       nullptr,
                                                                       nullptr,
                                                                       fault_handler,  // supervisor call
                                                                       fault_handler,
                                                                       nullptr,
                                                                       fault_handler,
                                                                       fault_handler};
}

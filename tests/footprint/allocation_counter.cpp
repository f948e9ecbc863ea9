// Counts every allocation of the program: the four operators new and malloc itself.
#include "tests/footprint/allocation_counter.hpp"

#include <cstdlib>
#include <new>

namespace {

unsigned long long allocations = 0;

}  // namespace

namespace footprint {

unsigned long long allocation_count() { return allocations; }

}  // namespace footprint

extern "C" void* __libc_malloc(size_t size);
extern "C" void* __libc_calloc(size_t count, size_t size);
extern "C" void* __libc_realloc(void* place, size_t size);

// operator new of libstdc++ calls malloc, so these three see everything.
extern "C" void* malloc(size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
extern "C" void* calloc(size_t count, size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
extern "C" void* realloc(void* place, size_t size) {
  ++allocations;
  return __libc_realloc(place, size);
}

// Linked into a program, makes every allocation after allocation_guard_begin() fatal: the proof that there is none.
// Stands in for malloc and its kin, which operator new uses too.
#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#include <atomic>

extern "C" {

void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

namespace {

std::atomic<bool> guarded{false};

void check() {
  if (!guarded.load(std::memory_order_relaxed)) return;
  guarded = false;
  static const char kText[] = "ALLOCATION AFTER START\n";
  static_cast<void>(!write(STDERR_FILENO, kText, sizeof kText - 1));
  abort();
}

}  // namespace

void allocation_guard_begin() { guarded = true; }
void allocation_guard_end() { guarded = false; }

void* malloc(size_t size) {
  check();
  return __libc_malloc(size);
}
void* calloc(size_t count, size_t size) {
  check();
  return __libc_calloc(count, size);
}
void* realloc(void* old, size_t size) {
  check();
  return __libc_realloc(old, size);
}
void* aligned_alloc(size_t alignment, size_t size) {
  check();
  return __libc_memalign(alignment, size);
}
void* memalign(size_t alignment, size_t size) {
  check();
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** result, size_t alignment, size_t size) {
  check();
  *result = __libc_memalign(alignment, size);
  return *result == nullptr ? ENOMEM : 0;
}

}  // extern "C"

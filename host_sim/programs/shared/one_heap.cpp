#include "host_sim/programs/shared/one_heap.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace host_sim {
namespace {

constexpr int kAtOnce = 32 << 20;  // bytes by which the heap grows
constexpr size_t kGrows = 1 << 20;
constexpr uintptr_t kLargePage = 2 << 20;

}  // namespace

void use_one_heap() {
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TOP_PAD, kAtOnce);
  void* volatile inside = std::malloc(kGrows);  // more than is left: the heap grows
  const auto from = (reinterpret_cast<uintptr_t>(inside) + kLargePage - 1) / kLargePage * kLargePage;
  const auto end = reinterpret_cast<uintptr_t>(sbrk(0));
  // Elsewhere the heap is no such part, or memory is somebody else's.
  if (from < end && end - from <= 2 * uintptr_t{kAtOnce})
    madvise(reinterpret_cast<void*>(from), end - from, MADV_HUGEPAGE);  // advice: without it pages are small
  std::free(inside);
}

}  // namespace host_sim

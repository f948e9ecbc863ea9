// A function, with all that it calls, compiled once more for wider vectors on a PC and chosen when the program starts; the numbers
// are the same. The widest vectors are for whole numbers alone: beside doubles the compiler would make one rounding of a product
// and a sum there.
#pragma once

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define FIRMWARE_WIDER_VECTORS [[gnu::target_clones("avx2", "default"), gnu::flatten]]
#define FIRMWARE_WIDEST_VECTORS [[gnu::target_clones("arch=x86-64-v4", "avx2", "default"), gnu::flatten]]
#else
#define FIRMWARE_WIDER_VECTORS
#define FIRMWARE_WIDEST_VECTORS
#endif

// A loop compiled once more for wider vectors, chosen when the program starts; the numbers are the same.
#pragma once

#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__)
#define RIG_WIDER_VECTORS [[gnu::target_clones("avx2", "default")]]
#else
#define RIG_WIDER_VECTORS
#endif

#include "firmware/conditioning/filter_sum.hpp"

#if defined(__thumb2__) && defined(__OPTIMIZE__) && !defined(__clang__)
#define FIRMWARE_BY_FOURS
#pragma GCC optimize("omit-frame-pointer")  // all registers are needed below
#endif

namespace firmware {
namespace {

// What a tap weighs: one sample, or the sum or difference of the next one of `first` and the last one before `second`.
enum class Weighs { kOne, kSum, kDifference };

struct Reader {
  const Tap* tap;
  const Code *first, *second;
};

template <Weighs kWeighs>
inline void add_next(Reader& at, int64_t& sum) {
  Code code = *at.first++;
  if (kWeighs == Weighs::kSum) code = code + *--at.second;
  if (kWeighs == Weighs::kDifference) code = code - *--at.second;
  sum += (*at.tap++ * code).raw;
}

#ifdef FIRMWARE_BY_FOURS
// As many as go by fours: loads of four registers at once and products that add to 64 bits, 13 instructions where a compiler
// makes 25 to 35. Gives how many are left.
template <Weighs kWeighs>
[[gnu::always_inline]] inline int add_fours(Reader& at, int count, int64_t& sum) {
  uint32_t low = static_cast<uint32_t>(sum), high = static_cast<uint32_t>(static_cast<uint64_t>(sum) >> 32);
#define FIRMWARE_FOURS(fold)                                                                                      \
  asm("subs %[count], #4\n\t"                                                                                     \
      "bmi 2f\n\t"                                                                                                \
      "1:\n\t"                                                                                                    \
      "ldmia %[first]!, {r4, r5, r6, r8}\n\t" fold                                                                \
      "ldmia %[tap]!, {r9, r10, r11, r12}\n\t"                                                                    \
      "smlal %[low], %[high], r4, r9\n\t"                                                                         \
      "smlal %[low], %[high], r5, r10\n\t"                                                                        \
      "smlal %[low], %[high], r6, r11\n\t"                                                                        \
      "smlal %[low], %[high], r8, r12\n\t"                                                                        \
      "subs %[count], #4\n\t"                                                                                     \
      "bpl 1b\n\t"                                                                                                \
      "2: adds %[count], #4"                                                                                      \
      : [low] "+r"(low), [high] "+r"(high), [tap] "+r"(at.tap), [first] "+r"(at.first), [second] "+r"(at.second), \
        [count] "+r"(count)                                                                                       \
      :                                                                                                           \
      : "r4", "r5", "r6", "r8", "r9", "r10", "r11", "r12", "cc", "memory")
#define FIRMWARE_FOLD(step)                                                                        \
  "ldmdb %[second]!, {r9, r10, r11, r12}\n\t" step " r4, r4, r12\n\t" step " r5, r5, r11\n\t" step \
  " r6, r6, r10\n\t" step " r8, r8, r9\n\t"
  if (kWeighs == Weighs::kOne) FIRMWARE_FOURS("");
  if (kWeighs == Weighs::kSum) FIRMWARE_FOURS(FIRMWARE_FOLD("add"));
  if (kWeighs == Weighs::kDifference) FIRMWARE_FOURS(FIRMWARE_FOLD("sub"));
#undef FIRMWARE_FOLD
#undef FIRMWARE_FOURS
  sum = static_cast<int64_t>(uint64_t{high} << 32 | low);
  return count;
}
#else
template <Weighs kWeighs>
inline int add_fours(Reader& at, int count, int64_t& sum) {
  for (; count >= 4; count -= 4)
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) add_next<kWeighs>(at, sum);
  return count;
}
#endif

template <Weighs kWeighs>
int64_t added(Reader at, int count, int64_t sum) {
  for (int rest = add_fours<kWeighs>(at, count, sum); rest != 0; --rest) add_next<kWeighs>(at, sum);
  return sum;
}

}  // namespace

int parity_of(const Tap* tap, int half_length) {
  bool even = half_length > 0, odd = even;
  for (int k = 0; k <= half_length; ++k) {
    const int32_t late = tap[half_length + k].raw, early = tap[half_length - k].raw;
    even = even && late == early;
    odd = odd && late == -early;
  }
  return even ? 1 : odd ? -1 : 0;
}

int64_t even_sum(const Tap* tap, const Code* middle, int half_length) {
  tap += half_length;
  return added<Weighs::kSum>({tap + 1, middle + 1, middle}, half_length, (*tap * *middle).raw);
}

// The middle tap is 0.
int64_t odd_sum(const Tap* tap, const Code* middle, int half_length) {
  return added<Weighs::kDifference>({tap + half_length + 1, middle + 1, middle}, half_length, 0);
}

int64_t filter_sum(int parity, const Tap* tap, const Code* middle, int half_length) {
  if (parity > 0) return even_sum(tap, middle, half_length);
  if (parity < 0) return odd_sum(tap, middle, half_length);
  return added<Weighs::kOne>({tap, middle - half_length, nullptr}, 2 * half_length + 1, 0);
}

}  // namespace firmware

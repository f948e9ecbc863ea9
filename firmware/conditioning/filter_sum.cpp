#include "firmware/conditioning/filter_sum.hpp"

#if defined(__thumb2__) && defined(__OPTIMIZE__) && !defined(__clang__)
#define FIRMWARE_BY_FOURS
#pragma GCC optimize("omit-frame-pointer")  // all registers are needed below
#endif

namespace firmware {
namespace {

// What a tap weighs: one sample, or the sum or difference of the next one of `first` and the last one before `second`.
enum class Weighs { kOne, kSum, kDifference };

#ifdef FIRMWARE_BY_FOURS
// The pair and the one that are left of the fours, then the fours, without a loop: a table of bytes says where to jump in. Loads of
// four registers at once and products that add to 64 bits: 11 instructions for a four where a compiler makes 25 to 35. `begin`
// goes to the first tap and the first sample, and sets what the sum starts with.
constexpr int most_fours(int taps) { return taps < 4 ? 1 : taps / 4; }
constexpr int kFourBytes = 24, kFoldBytes = 20;  // of the code of a four, and of that which folds the opposite samples
static_assert(most_fours(2 * kFilterHalf + 1) * (kFourBytes + 2) / 2 < 250, "a table of bytes");
static_assert(most_fours(kFilterHalf) * (kFourBytes + kFoldBytes + 2) / 2 < 250, "a table of bytes");

#define FIRMWARE_SUM(begin, fold_two, fold_one, fold_four, most, size)                                  \
  asm(begin                                                                                             \
      "lsls r4, %[count], #31\n\t"                                                                      \
      "bcc 1f\n\t"                                                                                      \
      "ldrd r4, r5, [%[first]], #8\n\t" fold_two                                                        \
      "ldrd r9, r10, [%[tap]], #8\n\t"                                                                  \
      "smlal %[low], %[high], r4, r9\n\t"                                                               \
      "smlal %[low], %[high], r5, r10\n"                                                                \
      "1:\n\t"                                                                                          \
      "bpl 2f\n\t"                                                                                      \
      "ldr r4, [%[first]], #4\n\t" fold_one                                                             \
      "ldr r9, [%[tap]], #4\n\t"                                                                        \
      "smlal %[low], %[high], r4, r9\n"                                                                 \
      "2:\n\t"                                                                                          \
      "lsrs r6, r6, #2\n\t"                                                                             \
      "tbb [pc, r6]\n"                                                                                  \
      ".set .Lleft, %c[fours]\n\t"                                                                      \
      ".rept %c[fours] + 1\n\t"                                                                         \
      ".byte (%c[fours] + 2) / 2 + .Lleft * %c[bytes] / 2\n\t"                                          \
      ".set .Lleft, .Lleft - 1\n\t"                                                                     \
      ".endr\n\t"                                                                                       \
      ".p2align 1\n\t"                                                                                  \
      ".rept %c[fours]\n\t"                                                                             \
      "ldmia.w %[first]!, {r4, r5, r6, r8}\n\t" fold_four                                               \
      "ldmia.w %[tap]!, {r9, r10, r11, r12}\n\t"                                                        \
      "smlal %[low], %[high], r4, r9\n\t"                                                               \
      "smlal %[low], %[high], r5, r10\n\t"                                                              \
      "smlal %[low], %[high], r6, r11\n\t"                                                              \
      "smlal %[low], %[high], r8, r12\n\t"                                                              \
      ".endr"                                                                                           \
      : [low] "=&r"(low), [high] "=&r"(high), [tap] "+r"(tap), [first] "=&r"(first), [second] "+r"(at), \
        [count] "+r"(count)                                                                             \
      : [fours] "i"(most), [bytes] "i"(size)                                                            \
      : "r4", "r5", "r8", "r9", "r10", "r11", "r12", "cc", "memory")
#define FIRMWARE_FOLDED(begin, step)                                                                              \
  FIRMWARE_SUM(begin, "ldrd r9, r10, [%[second], #-8]!\n\t" step " r4, r4, r10\n\t" step " r5, r5, r9\n\t",       \
               "ldr r9, [%[second], #-4]!\n\t" step " r4, r4, r9\n\t",                                            \
               "ldmdb.w %[second]!, {r9, r10, r11, r12}\n\t" step " r4, r4, r12\n\t" step " r5, r5, r11\n\t" step \
               " r6, r6, r10\n\t" step " r8, r8, r9\n\t",                                                         \
               most_fours(kFilterHalf), kFourBytes + kFoldBytes)

// at: the middle sample, and taps on either side; where one sample is weighed alone, the oldest one and all taps.
template <Weighs kWeighs>
[[gnu::always_inline]] inline int64_t sum_of(const Tap* tap, const Code* at, int taps) {
  register int count asm("r6") = taps;
  const Code* first;
  uint32_t low, high;
  if (kWeighs == Weighs::kOne)
    FIRMWARE_SUM(
        "mov %[first], %[second]\n\t"
        "mov %[low], #0\n\t"
        "mov %[high], #0\n\t",
        "", "", "", most_fours(2 * kFilterHalf + 1), kFourBytes);
  if (kWeighs == Weighs::kSum)
    FIRMWARE_FOLDED(
        "add %[tap], %[tap], r6, lsl #2\n\t"
        "mov %[first], %[second]\n\t"
        "ldr %[low], [%[tap]], #4\n\t"
        "ldr %[high], [%[first]], #4\n\t"
        "smull %[low], %[high], %[low], %[high]\n\t",
        "add.w");
  if (kWeighs == Weighs::kDifference)
    FIRMWARE_FOLDED(
        "add %[tap], %[tap], r6, lsl #2\n\t"
        "add %[first], %[second], #4\n\t"
        "add %[tap], %[tap], #4\n\t"
        "mov %[low], #0\n\t"
        "mov %[high], #0\n\t",
        "sub.w");
  return static_cast<int64_t>(uint64_t{high} << 32 | low);
}
#undef FIRMWARE_FOLDED
#undef FIRMWARE_SUM
#else
template <Weighs kWeighs>
inline int64_t sum_of(const Tap* tap, const Code* at, int taps) {
  int64_t sum = 0;
  if (kWeighs == Weighs::kOne) {
    for (int k = 0; k < taps; ++k) sum += (tap[k] * at[k]).raw;
    return sum;
  }
  tap += taps;
  if (kWeighs == Weighs::kSum) sum = (*tap * *at).raw;
#pragma GCC unroll 4
  for (int k = 1; k <= taps; ++k) sum += (tap[k] * (kWeighs == Weighs::kSum ? at[k] + at[-k] : at[k] - at[-k])).raw;
  return sum;
}
#endif

// Just beyond the limit where it is beyond.
inline Code nearest_of_many_bits(int64_t sum, int shift) {
  const int64_t value = shift > 0 ? (sum + (int64_t{1} << (shift - 1))) >> shift : sum;
  const int64_t beyond = kSignalLimit + 1;
  return Code::from_raw(static_cast<int32_t>(value > beyond ? beyond : value < -beyond ? -beyond : value));
}

// From 32 bits on the upper word says it, but for a half, as |sum| < 2^62.
inline Code rounded(int64_t sum, int shift) {
  const int32_t upper = static_cast<int32_t>(sum >> 32);
  const int beyond_half = shift - 33;
  if (beyond_half >= 0) return Code::from_raw(((upper >> beyond_half) + 1) >> 1);
  if (shift == 32) return Code::from_raw(upper + static_cast<int32_t>(static_cast<uint32_t>(sum) >> 31));
  return nearest_of_many_bits(sum, shift);
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

int64_t filter_sum(const Tap* tap, const Code* middle, int half_length) {
  return sum_of<Weighs::kOne>(tap, middle - half_length, 2 * half_length + 1);
}

Code nearest(int64_t sum, int shift) { return rounded(sum, shift); }

Code even_signal(const SignalConfiguration& signal, const Code* middle) {
  return rounded(sum_of<Weighs::kSum>(signal.tap, middle, signal.half_length), signal.shift);
}
Code odd_signal(const SignalConfiguration& signal, const Code* middle) {
  return rounded(sum_of<Weighs::kDifference>(signal.tap, middle, signal.half_length), signal.shift);
}
Code filter_signal(const SignalConfiguration& signal, const Code* middle, int parity) {
  if (parity > 0) return even_signal(signal, middle);
  if (parity < 0) return odd_signal(signal, middle);
  return rounded(filter_sum(signal.tap, middle, signal.half_length), signal.shift);
}

}  // namespace firmware

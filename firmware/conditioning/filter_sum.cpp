#include "firmware/conditioning/filter_sum.hpp"

namespace firmware {
namespace {

// Steps of the loops below at a time, so that a small processor spends its time on products and not on counting.
constexpr int kAtATime = 4;

// Tap by tap: read ahead, the numbers would not fit such a processor's registers.
inline void in_order() {
#ifdef __thumb__
  asm volatile("" ::: "memory");
#endif
}

template <bool kOdd>
int64_t folded_sum(const Tap* tap, const Code* middle, int half_length) {
  int64_t sum = (tap[0] * middle[0]).raw;
  const Code *newer = middle, *older = middle;
  const Tap* last = tap + half_length;
  for (; last - tap >= kAtATime; tap += kAtATime, newer += kAtATime, older -= kAtATime)
#pragma GCC unroll 4
    for (int k = 1; k <= kAtATime; ++k, in_order())
      sum += (tap[k] * (kOdd ? newer[k] - older[-k] : newer[k] + older[-k])).raw;
  while (tap != last) {
    const Code late = *++newer, early = *--older;
    sum += (*++tap * (kOdd ? late - early : late + early)).raw;
  }
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

int64_t filter_sum(int parity, const Tap* tap, const Code* middle, int half_length) {
  if (parity > 0) return folded_sum<false>(tap + half_length, middle, half_length);
  if (parity < 0) return folded_sum<true>(tap + half_length, middle, half_length);
  const Code* first = middle - half_length;
  int64_t sum = 0;
  for (int k = 0; k <= 2 * half_length; ++k) sum += (tap[k] * first[k]).raw;
  return sum;
}

OddAndEven odd_and_even_sum(const Tap* odd_tap, const Tap* even_tap, const Code* middle, int half_length) {
  const Tap *first = odd_tap + half_length, *second = even_tap + half_length, *last = first + half_length;
  const Code *newer = middle, *older = middle;
  int64_t odd = 0, even = (second[0] * middle[0]).raw;
  const auto add = [&](int k) {
    const Code late = newer[k], early = older[-k];
    odd += (first[k] * (late - early)).raw;
    even += (second[k] * (late + early)).raw;
  };
  for (; last - first >= kAtATime; first += kAtATime, second += kAtATime, newer += kAtATime, older -= kAtATime)
#pragma GCC unroll 4
    for (int k = 1; k <= kAtATime; ++k, in_order()) add(k);
  for (; first != last; ++first, ++second, ++newer, --older) add(1);
  return {odd, even};
}

ThreeSums three_sums(const SignalConfiguration* signal, const Code* middle) {
  constexpr int kNext = sizeof(SignalConfiguration) / sizeof(Tap);  // from a tap of the velocity to the acceleration's
  const Tap *tap = signal[1].tap + signal[1].half_length, *x_tap = signal[0].tap + signal[0].half_length;
  const Tap *last = tap + signal[0].half_length, *end = tap + signal[1].half_length;
  const Code *newer = middle, *older = middle;
  int64_t x = (x_tap[0] * middle[0]).raw, v = 0, a = (tap[kNext] * middle[0]).raw;
  const auto add = [&](int k, bool all) {
    const Code late = newer[k], early = older[-k];
    v += (tap[k] * (late - early)).raw;
    const Code sum = late + early;
    a += (tap[kNext + k] * sum).raw;
    if (all) x += (x_tap[k] * sum).raw;
  };
  const auto move = [&](int by) { x_tap += by, tap += by, newer += by, older -= by; };
  for (; last - tap >= kAtATime; move(kAtATime))
#pragma GCC unroll 4
    for (int k = 1; k <= kAtATime; ++k, in_order()) add(k, true);
  for (; tap != last; move(1)) add(1, true);
  for (; end - tap >= kAtATime; move(kAtATime))
#pragma GCC unroll 4
    for (int k = 1; k <= kAtATime; ++k, in_order()) add(k, false);
  for (; tap != end; move(1)) add(1, false);
  return {x, v, a};
}

}  // namespace firmware

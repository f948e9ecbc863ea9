// Combinations of the sums of stretches. On a PC of many of them: eight side by side, where the processor has vectors of 256 bits.
#include "firmware/warrant/sums/combination.hpp"

#ifdef FIRMWARE_IN_PLACE
#include <immintrin.h>

namespace firmware {
namespace {

constexpr int64_t kNothing = -(int64_t{1} << 40);  // no product's exponent

// Four numbers of a value.
struct Four {
  __m256i mantissa, exponent;
};
[[gnu::target("avx2"), gnu::always_inline]] inline Four four_of(const int32_t* mantissas, const int8_t* exponents) {
  int32_t bytes;
  __builtin_memcpy(&bytes, exponents, sizeof bytes);
  return {_mm256_cvtepi32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(mantissas))),
          _mm256_cvtepi8_epi64(_mm_cvtsi32_si128(bytes))};
}

// Of two numbers without a sign, where a shift by 64 and more leaves nothing: the products are lifted above zero by 2^62 before, and
// what that makes is taken off again. It is the shift of sum_of_products, to the last bit: 2^62 is a whole multiple of 2^shift.
[[gnu::target("avx2"), gnu::always_inline]] inline __m256i shifted_down(__m256i product, __m256i shift) {
  const __m256i lift = _mm256_set1_epi64x(int64_t{1} << 62);
  return _mm256_sub_epi64(_mm256_srlv_epi64(_mm256_add_epi64(product, lift), shift), _mm256_srlv_epi64(lift, shift));
}

[[gnu::target("avx2")]] void combine_eight(const ShortScaled* coefficient, const uint16_t* value, int count,
                                           const ScoreTable& table, int from, Scaled* sums) {
  const __m256i nothing = _mm256_set1_epi64x(kNothing), bits = _mm256_set1_epi64x(bits_of_sum(count));
  __m256i largest[2] = {nothing, nothing}, sum[2] = {_mm256_setzero_si256(), _mm256_setzero_si256()};
  for (int i = 0; i < count; ++i) {
    const __m256i factor = _mm256_set1_epi64x(coefficient[i].mantissa),
                  exponent = _mm256_set1_epi64x(coefficient[i].exponent);
    for (int half = 0; half < 2; ++half) {
      const Four four =
          four_of(table.mantissas(value[i]) + from + 4 * half, table.exponents(value[i]) + from + 4 * half);
      const __m256i product = _mm256_mul_epi32(four.mantissa, factor), of = _mm256_add_epi64(four.exponent, exponent);
      const __m256i none = _mm256_cmpeq_epi64(product, _mm256_setzero_si256());
      const __m256i counts = _mm256_blendv_epi8(of, nothing, none);
      largest[half] = _mm256_blendv_epi8(largest[half], counts, _mm256_cmpgt_epi64(counts, largest[half]));
    }
  }
  for (int i = 0; i < count; ++i) {
    const __m256i factor = _mm256_set1_epi64x(coefficient[i].mantissa),
                  exponent = _mm256_sub_epi64(bits, _mm256_set1_epi64x(coefficient[i].exponent));
    for (int half = 0; half < 2; ++half) {
      const Four four =
          four_of(table.mantissas(value[i]) + from + 4 * half, table.exponents(value[i]) + from + 4 * half);
      const __m256i shift = _mm256_sub_epi64(_mm256_add_epi64(largest[half], exponent), four.exponent);
      sum[half] = _mm256_add_epi64(sum[half], shifted_down(_mm256_mul_epi32(four.mantissa, factor), shift));
    }
  }
  alignas(32) int64_t most[8], total[8];
  for (int half = 0; half < 2; ++half) {
    _mm256_store_si256(reinterpret_cast<__m256i*>(most + 4 * half), largest[half]);
    _mm256_store_si256(reinterpret_cast<__m256i*>(total + 4 * half), sum[half]);
  }
  for (int k = 0; k < 8; ++k)
    sums[from + k] =
        most[k] == kNothing ? Scaled{} : Scaled::from_int(total[k], static_cast<int32_t>(most[k]) + bits_of_sum(count));
}

}  // namespace

int combine(const ShortScaled* coefficient, const uint16_t* value, int count, const ScoreTable& table, int from, int to,
            Scaled* sums) {
  const bool wide = __builtin_cpu_supports("avx2") != 0;
  for (; wide && from + 8 <= to; from += 8) combine_eight(coefficient, value, count, table, from, sums);
  return from;
}

}  // namespace firmware

#else

namespace firmware {

Scaled combined(const ShortScaled* coefficient, int count, const ShortScaled* number, const uint16_t* value,
                const ScoreTable* table, int stretch) {
  if (table != nullptr) report_work(100 + 50 * count);
  return sum_in_two_passes(
      count, [&](int i) { return coefficient[i]; },
      [&](int i) { return table != nullptr ? table->number(stretch, value[i]) : number[i]; });
}

}  // namespace firmware

#endif

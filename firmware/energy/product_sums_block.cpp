// The sums over a whole block of 32 samples, where most of the path's multiplications are. Both ways are exact, so they
// give the same bits; which one is cheaper depends on the processor.
#include "firmware/energy/product_sums.hpp"
#include "firmware/fixed_point/wider_vectors.hpp"

namespace firmware {
namespace {

#if FIRMWARE_HAS_VECTORS

int64_t dot(const int32_t* __restrict a, const int32_t* __restrict b) {
  int64_t sum = 0;
  for (int i = 0; i < kBlockSamples; ++i) sum += static_cast<int64_t>(a[i]) * b[i];
  return sum;
}

#else

int64_t step(int64_t sum, int32_t a, int32_t b) { return sum + static_cast<int64_t>(a) * b; }

// One column with each of three others, added to three sums: four loads for three multiplications. Written out in full, it
// needs neither a counter nor a step of its four pointers, and a small processor's registers hold all of it.
[[gnu::always_inline]] inline void add_dot3(const int32_t* shared, const int32_t* x, const int32_t* y, const int32_t* z,
                                            int64_t& sum_x, int64_t& sum_y, int64_t& sum_z) {
  int64_t own_x = sum_x, own_y = sum_y, own_z = sum_z;
#pragma GCC unroll 32
  for (int i = 0; i < kBlockSamples; ++i) {
    const int32_t s = shared[i];
    own_x = step(own_x, s, x[i]);
    own_y = step(own_y, s, y[i]);
    own_z = step(own_z, s, z[i]);
    asm volatile("" ::: "memory");  // sample by sample: read ahead, the numbers would not fit the registers
  }
  sum_x = own_x;
  sum_y = own_y;
  sum_z = own_z;
}

int64_t dot1(const int32_t* a, const int32_t* b) {
  int64_t sum = 0;
#pragma GCC unroll 4
  for (int i = 0; i < kBlockSamples; ++i) sum = step(sum, a[i], b[i]);
  return sum;
}

#endif

}  // namespace

#if FIRMWARE_HAS_VECTORS

FIRMWARE_WIDEST_VECTORS int64_t dot_block(const int32_t* a, const int32_t* b) { return dot(a, b); }

FIRMWARE_WIDEST_VECTORS void add_dots(const int32_t* shared, const int32_t* const* other, int count, int64_t* sum) {
  for (int k = 0; k < count; ++k) sum[k] += dot(shared, other[k]);
}

FIRMWARE_WIDEST_VECTORS void ProductSums::add_whole_block(const Frame& frame, int from) {
  for (int i = 0; i < product_count_; ++i)
    sum_[i] += dot(&frame.raw[product_[i].a][from], &frame.raw[product_[i].b][from]);
}

#else

int64_t dot_block(const int32_t* a, const int32_t* b) { return dot1(a, b); }

void add_dots(const int32_t* shared, const int32_t* const* other, int count, int64_t* sum) {
  int k = 0;
  for (; k + 3 <= count; k += 3) add_dot3(shared, other[k], other[k + 1], other[k + 2], sum[k], sum[k + 1], sum[k + 2]);
  for (; k < count; ++k) sum[k] += dot1(shared, other[k]);
}

void ProductSums::add_whole_block(const Frame& frame, int from) {
  const int32_t* first = &frame.raw[0][from];
  for (const Group *group = group_, *end = group_ + group_count_; group != end; ++group)
    add_dot3(first + group->shared, first + group->other[0], first + group->other[1], first + group->other[2],
             sum_[group->product[0]], sum_[group->product[1]], sum_[group->product[2]]);
  for (int i = 0; i < single_count_; ++i) {
    const Product& p = product_[single_[i]];
    sum_[single_[i]] += dot1(&frame.raw[p.a][from], &frame.raw[p.b][from]);
  }
}

#endif

}  // namespace firmware

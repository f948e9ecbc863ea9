// The sums over a whole block of 32 samples, where most of the path's multiplications are. Both ways are exact, so they
// give the same bits; which one is cheaper depends on the processor.
#include "firmware/energy/product_sums.hpp"

namespace firmware {
namespace {

#if FIRMWARE_HAS_VECTORS

// Offset-binary numbers (c + 2^31, unsigned, modulo 2^64): every vector unit multiplies 32 by 32 bits without sign.
constexpr uint32_t kOffset = 0x80000000u;

uint32_t offset_binary(int32_t value) { return static_cast<uint32_t>(value) ^ kOffset; }

uint64_t offset_dot(const int32_t* __restrict a, const int32_t* __restrict b) {
  uint64_t sum = 0;
  for (int i = 0; i < kBlockSamples; ++i) sum += static_cast<uint64_t>(offset_binary(a[i])) * offset_binary(b[i]);
  return sum;
}

uint64_t offset_sum(const int32_t* __restrict a) {
  uint64_t sum = 0;
  for (int i = 0; i < kBlockSamples; ++i) sum += offset_binary(a[i]);
  return sum;
}

#else

int64_t step(int64_t sum, int32_t a, int32_t b) { return sum + static_cast<int64_t>(a) * b; }

// One column with each of three others: four loads for three multiplications.
void dot3(const int32_t* shared, const int32_t* const* other, int64_t* sum) {
  const int32_t *x = other[0], *y = other[1], *z = other[2];
  int64_t sum_x = 0, sum_y = 0, sum_z = 0;
#pragma GCC unroll 4
  for (int i = 0; i < kBlockSamples; ++i) {
    const int32_t s = shared[i];
    sum_x = step(sum_x, s, x[i]);
    sum_y = step(sum_y, s, y[i]);
    sum_z = step(sum_z, s, z[i]);
  }
  sum[0] = sum_x;
  sum[1] = sum_y;
  sum[2] = sum_z;
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

int64_t dot_block(const int32_t* a, const int32_t* b) {
  const uint64_t offsets =
      kOffset * (offset_sum(a) + offset_sum(b)) - static_cast<uint64_t>(kBlockSamples) * kOffset * kOffset;
  return static_cast<int64_t>(offset_dot(a, b) - offsets);
}

void ProductSums::finish_plan() {
  column_count_ = 0;
  for (int i = 0; i < product_count_; ++i)
    for (int side = 0; side < 2; ++side) {
      const uint16_t column = side == 0 ? product_[i].a : product_[i].b;
      int place = 0;
      while (place < column_count_ && column_[place] != column) ++place;
      if (place == column_count_) column_[column_count_++] = column;
      (side == 0 ? rank_a_ : rank_b_)[i] = static_cast<uint16_t>(place);
    }
}

void ProductSums::add_whole_block(const Frame& frame, int from) {
  uint64_t column_sum[kMaxColumns];
  for (int c = 0; c < column_count_; ++c) column_sum[c] = offset_sum(&frame.raw[column_[c]][from]);
  for (int i = 0; i < product_count_; ++i) {
    // sum of (a + O)(b + O) = sum of a b + O (sum of (a + O) + sum of (b + O)) - n O^2, all modulo 2^64
    const uint64_t raw = offset_dot(&frame.raw[product_[i].a][from], &frame.raw[product_[i].b][from]);
    const uint64_t offsets = kOffset * (column_sum[rank_a_[i]] + column_sum[rank_b_[i]]) -
                             static_cast<uint64_t>(kBlockSamples) * kOffset * kOffset;
    sum_[i] += static_cast<int64_t>(raw - offsets);
  }
}

#else

int64_t dot_block(const int32_t* a, const int32_t* b) { return dot1(a, b); }

void ProductSums::group_around(int column, bool (&done)[kMaxProducts]) {
  Group group = {};
  group.shared = static_cast<uint16_t>(column);
  int members = 0;
  for (int i = 0; i < product_count_; ++i) {
    const Product& p = product_[i];
    if (done[i] || (p.a != column && p.b != column)) continue;
    group.other[members] = p.a == column ? p.b : p.a;
    group.product[members] = static_cast<uint16_t>(i);
    if (++members < 3) continue;
    for (uint16_t product : group.product) done[product] = true;
    group_[group_count_++] = group;
    members = 0;
  }
}

void ProductSums::finish_plan() {
  bool done[kMaxProducts] = {};
  group_count_ = single_count_ = 0;
  for (int column = 0; column < kMaxColumns; ++column) group_around(column, done);
  for (int i = 0; i < product_count_; ++i)
    if (!done[i]) single_[single_count_++] = static_cast<uint16_t>(i);
}

void ProductSums::add_whole_block(const Frame& frame, int from) {
  for (int g = 0; g < group_count_; ++g) {
    const Group& group = group_[g];
    const int32_t* other[3];
    for (int k = 0; k < 3; ++k) other[k] = &frame.raw[group.other[k]][from];
    int64_t sum[3];
    dot3(&frame.raw[group.shared][from], other, sum);
    for (int k = 0; k < 3; ++k) sum_[group.product[k]] += sum[k];
  }
  for (int i = 0; i < single_count_; ++i) {
    const Product& p = product_[single_[i]];
    sum_[single_[i]] += dot1(&frame.raw[p.a][from], &frame.raw[p.b][from]);
  }
}

#endif

}  // namespace firmware

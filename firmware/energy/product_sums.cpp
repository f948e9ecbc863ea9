#include "firmware/energy/product_sums.hpp"

namespace firmware {
namespace {

constexpr uint32_t kOffset = 0x80000000u;

uint32_t offset_binary(int32_t value) { return static_cast<uint32_t>(value) ^ kOffset; }

uint64_t offset_dot_block(const int32_t* __restrict a, const int32_t* __restrict b) {
  uint64_t sum = 0;
  for (int i = 0; i < kBlockSamples; ++i) sum += static_cast<uint64_t>(offset_binary(a[i])) * offset_binary(b[i]);
  return sum;
}

uint64_t offset_sum_block(const int32_t* __restrict a) {
  uint64_t sum = 0;
  for (int i = 0; i < kBlockSamples; ++i) sum += offset_binary(a[i]);
  return sum;
}

int64_t dot(const int32_t* a, const int32_t* b, int count) {
  int64_t sum = 0;
  for (int i = 0; i < count; ++i) sum += static_cast<int64_t>(a[i]) * b[i];
  return sum;
}

}  // namespace

int16_t ProductSums::add(int column_a, int column_b) {
  if (column_b < column_a) {
    const int swap = column_a;
    column_a = column_b;
    column_b = swap;
  }
  for (int i = 0; i < product_count_; ++i)
    if (product_[i].a == column_a && product_[i].b == column_b) return static_cast<int16_t>(i);
  if (product_count_ == kMaxProducts) return kNoProduct;
  uint16_t rank[2];
  const int columns[2] = {column_a, column_b};
  for (int side = 0; side < 2; ++side) {
    int place = 0;
    while (place < column_count_ && column_[place] != columns[side]) ++place;
    if (place == column_count_) column_[column_count_++] = static_cast<uint16_t>(columns[side]);
    rank[side] = static_cast<uint16_t>(place);
  }
  product_[product_count_] = {static_cast<uint16_t>(column_a), static_cast<uint16_t>(column_b), rank[0], rank[1]};
  return static_cast<int16_t>(product_count_++);
}

void ProductSums::ends(const Frame& frame, int at, int64_t* result) const {
  for (int i = 0; i < product_count_; ++i) {
    const int32_t* a = &frame.column[product_[i].a][at];
    const int32_t* b = &frame.column[product_[i].b][at];
    result[i] = 12 * (static_cast<int64_t>(a[0]) * b[0]) - static_cast<int64_t>(a[1]) * b[1] +
                static_cast<int64_t>(a[-1]) * b[-1];
  }
}

void ProductSums::start(const Frame& frame, int at) {
  ends(frame, at, start_);
  for (int i = 0; i < product_count_; ++i) sum_[i] = 0;
}

void ProductSums::add_block(const Frame& frame, int from, int to) {
  if (to - from != kBlockSamples) {
    for (int i = 0; i < product_count_; ++i)
      sum_[i] += dot(&frame.column[product_[i].a][from], &frame.column[product_[i].b][from], to - from);
    return;
  }
  uint64_t column_sum[kMaxColumns];
  for (int c = 0; c < column_count_; ++c) column_sum[c] = offset_sum_block(&frame.column[column_[c]][from]);
  for (int i = 0; i < product_count_; ++i) {
    const Product& p = product_[i];
    // sum of (a + O)(b + O) = sum of a b + O (sum of (a + O) + sum of (b + O)) - n O^2, all modulo 2^64
    const uint64_t raw = offset_dot_block(&frame.column[p.a][from], &frame.column[p.b][from]);
    const uint64_t offsets = kOffset * (column_sum[p.rank_a] + column_sum[p.rank_b]) -
                             static_cast<uint64_t>(kBlockSamples) * kOffset * kOffset;
    sum_[i] += static_cast<int64_t>(raw - offsets);
  }
}

void ProductSums::stop(const Frame& frame, int at) { ends(frame, at, end_); }

}  // namespace firmware

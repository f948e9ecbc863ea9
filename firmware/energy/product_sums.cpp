#include "firmware/energy/product_sums.hpp"

#include "firmware/fixed_point/precondition.hpp"

namespace firmware {
namespace {

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
  if (product_count_ == kMaxProducts) {
    complete_ = false;
    return kNoProduct;
  }
  product_[product_count_] = {static_cast<uint16_t>(column_a), static_cast<uint16_t>(column_b)};
  return static_cast<int16_t>(product_count_++);
}

#if FIRMWARE_HAS_VECTORS
void ProductSums::finish_plan() {}
#else
void ProductSums::group_around(int column, bool (&done)[kMaxProducts]) {
  Group group = {};
  group.shared = static_cast<uint16_t>(column * kFrameStride);
  int members = 0;
  for (int i = 0; i < product_count_; ++i) {
    const Product& p = product_[i];
    if (done[i] || (p.a != column && p.b != column)) continue;
    group.other[members] = static_cast<uint16_t>((p.a == column ? p.b : p.a) * kFrameStride);
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
#endif

void ProductSums::start(const Frame& frame, int at) {
  FIRMWARE_PRECONDITION(at >= 1 && at + 1 < kFrameSamples);
  for (int i = 0; i < product_count_; ++i) {
    ends_[i] = end(product_[i], frame, at);
    sum_[i] = 0;
  }
}

void ProductSums::add_block(const Frame& frame, int from, int to) {
  FIRMWARE_PRECONDITION(from >= kLeadIn && from <= to && to <= kFrameSamples && to - from <= kBlockSamples);
  if (to - from == kBlockSamples) return add_whole_block(frame, from);
  for (int i = 0; i < product_count_; ++i)
    sum_[i] += dot(&frame.raw[product_[i].a][from], &frame.raw[product_[i].b][from], to - from);
}

}  // namespace firmware

// Exact running sums of products of two columns, each pair of columns once however many equations need it.
//
// Over the window from sample s to sample e an integral is, with the end corrections of Gregory's rule,
//   h * ( sum over s <= n < e of p_n  +  end(e) - end(s) ),   end(n) = p_n / 2 - (p_{n+1} - p_{n-1}) / 24
// which is the trapezoid with fourth-order ends. Applied to every product alike it keeps a property that Simpson's weights
// have too: where all signals of an equation of motion are sampled together, its weighted sum is zero to the last bit.
//
// Formats: products below 2^52.4 (columns.hpp), 1024 of them below 2^62.4; end corrections times 24 below 2^57.
// The sum over a block is exact, so how it is done does not show (product_sums_block.cpp): with a vector unit one product after the
// other, without one three at a time that share a column.
#pragma once
#include "firmware/acquisition/columns.hpp"

#if (defined(__SSE2__) || defined(__ARM_NEON)) && !defined(FIRMWARE_WITHOUT_VECTORS)
#define FIRMWARE_HAS_VECTORS 1
#else
#define FIRMWARE_HAS_VECTORS 0
#endif

namespace firmware {

constexpr int16_t kNoProduct = -1;

// Sum of a[i] * b[i] over kBlockSamples entries, exact in int64.
int64_t dot_block(const int32_t* a, const int32_t* b);
// sum[k] += the same of shared and other[k], for count of them.
void add_dots(const int32_t* shared, const int32_t* const* other, int count, int64_t* sum);

class ProductSums {
 public:
  void clear_plan() {
    product_count_ = 0;
    complete_ = true;
  }
  bool complete() const { return complete_; }  // every product that was asked for has found room
  int count() const { return product_count_; }
  int column_a(int product) const { return product_[product].a; }
  int column_b(int product) const { return product_[product].b; }
  int16_t add(int column_a, int column_b);  // the product's number; an existing one is found again
  void finish_plan();                       // after the last add()

  void start(const Frame& frame, int at);                // a window starts at this position of the frame
  void add_block(const Frame& frame, int from, int to);  // positions from <= n < to
  int64_t sum(int product) const { return sum_[product]; }
  // The window ends at this position and the next one starts there: the sum, and both ends' corrections times 24.
  struct Sum {
    int64_t sum, ends_times_24;
  };
  Sum turn(int product, const Frame& frame, int at) {
    const int64_t end_here = end(product_[product], frame, at);
    const Sum closed = {sum_[product], end_here - ends_[product]};
    sum_[product] = 0;
    ends_[product] = end_here;
    return closed;
  }

 private:
  struct Product {
    uint16_t a, b;  // columns
  };
  // Columns hold at most 10 * 2^23: twelve times that fits 32 bits.
  static int64_t end(const Product& product, const Frame& frame, int at) {
    const int32_t* a = &frame.raw[product.a][at];
    const int32_t* b = &frame.raw[product.b][at];
    return static_cast<int64_t>(12 * a[0]) * b[0] - static_cast<int64_t>(a[1]) * b[1] +
           static_cast<int64_t>(a[-1]) * b[-1];
  }
  void add_whole_block(const Frame& frame, int from);

  int product_count_ = 0;
  bool complete_ = true;
  Product product_[kMaxProducts];
#if !FIRMWARE_HAS_VECTORS
  struct Group {  // three products that share a column; columns as so many numbers from the frame's start
    uint16_t shared, other[3], product[3];
  };
  static_assert(kMaxColumns * kFrameStride <= 65535, "a group's columns");
  void group_around(int column, bool (&done)[kMaxProducts]);
  Group group_[kMaxProducts / 3];
  uint16_t single_[kMaxProducts];
  int group_count_ = 0, single_count_ = 0;
#endif
  int64_t sum_[kMaxProducts];
  int64_t ends_[kMaxProducts];  // end corrections times 24 of the start
};

}  // namespace firmware

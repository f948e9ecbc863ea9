// Exactness of the product sums: at the stated bound, at full scale, and against 128-bit sums.
#include "firmware/energy/product_sums.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>

using namespace firmware;

namespace {

constexpr int32_t kLargestInstrument = 10 * (1 << 23);
constexpr int32_t kLargestEffect = 1 << 26;

// Runs whole blocks of one frame through the sums.
struct Bench {
  std::unique_ptr<Frame> frame = std::make_unique<Frame>();
  std::unique_ptr<ProductSums> sums = std::make_unique<ProductSums>();
  Bench() { sums->clear_plan(); }
  void fill(int column, int32_t value) {
    for (int i = 0; i < kFrameStride; ++i) frame->raw[column][i] = value;
  }
};

}  // namespace

TEST(ProductSums, HoldTheLongestBatchAtFullScale) {
  // 1024 products of the largest magnitudes, -(10 * 2^23) * 2^26: -1024 * 10 * 2^49 = -10 * 2^59 > -2^63.
  Bench bench;
  const int16_t product = bench.sums->add(kInstrumentColumn, kEffectColumn);
  bench.sums->finish_plan();
  bench.fill(kInstrumentColumn, -kLargestInstrument);
  bench.fill(kEffectColumn, kLargestEffect);
  bench.sums->start(*bench.frame, kLeadIn);
  for (int block = 0; block < kMaxBatchSamples / kBlockSamples; ++block)
    bench.sums->add_block(*bench.frame, kLeadIn, kLeadIn + kBlockSamples);
  const ProductSums::Sum closed = bench.sums->turn(product, *bench.frame, kLeadIn);
  EXPECT_EQ(closed.sum, -10 * (int64_t{1} << 59));
  EXPECT_EQ(closed.ends_times_24, 0);  // the same values at both ends
}

TEST(ProductSums, WholeAndPartBlocksGiveThe128BitSum) {
  Bench bench;
  const int16_t product = bench.sums->add(3, 7);
  bench.sums->finish_plan();
  std::mt19937_64 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    for (int column : {3, 7})
      for (int i = 0; i < kFrameStride; ++i)
        bench.frame->raw[column][i] = static_cast<int32_t>(random() % (1u << 24)) - (1 << 23);
    const int count = trial % 2 == 0 ? kBlockSamples : 1 + trial % 31;
    bench.sums->start(*bench.frame, kLeadIn);
    bench.sums->add_block(*bench.frame, kLeadIn, kLeadIn + count);
    __int128 expected = 0;
    for (int i = 0; i < count; ++i)
      expected += static_cast<__int128>(bench.frame->raw[3][kLeadIn + i]) * bench.frame->raw[7][kLeadIn + i];
    EXPECT_EQ(bench.sums->sum(product), static_cast<int64_t>(expected));
  }
}

// Columns 0 to 4 with one another: pairs that share a column, squares, and what is left over when all threes are made.
TEST(ProductSums, ProductsThatShareColumnsKeepTheirOwnSums) {
  Bench bench;
  std::mt19937_64 random(8);
  for (int column = 0; column < 5; ++column)
    for (int i = 0; i < kFrameStride; ++i)
      bench.frame->raw[column][i] = static_cast<int32_t>(random() % (1u << 24)) - (1 << 23);
  for (int a = 0; a < 5; ++a)
    for (int b = a; b < 5; ++b) bench.sums->add(a, b);
  bench.sums->finish_plan();
  bench.sums->start(*bench.frame, kLeadIn);
  bench.sums->add_block(*bench.frame, kLeadIn, kLeadIn + kBlockSamples);
  bench.sums->add_block(*bench.frame, kLeadIn, kLeadIn + kBlockSamples);
  ASSERT_EQ(bench.sums->count(), 15);
  for (int p = 0; p < 15; ++p) {
    const int32_t* a = bench.frame->raw[bench.sums->column_a(p)];
    const int32_t* b = bench.frame->raw[bench.sums->column_b(p)];
    int64_t expected = 0;
    for (int i = kLeadIn; i < kLeadIn + kBlockSamples; ++i) expected += 2 * static_cast<int64_t>(a[i]) * b[i];
    EXPECT_EQ(bench.sums->sum(p), expected)
        << "columns " << bench.sums->column_a(p) << " and " << bench.sums->column_b(p);
  }
}

TEST(ProductSums, EndCorrectionsMakeTheTrapezoidOfFourthOrder) {
  // p_n = n * n (columns n and n) from n = 0 to 4: the integral of t^2 is 64/3. The sum 0 + 1 + 4 + 9 = 14; the ends are
  // p/2 - (p[+1] - p[-1])/24: at 4: 8 - (25 - 9)/24 = 22/3, at 0: 0 - (1 - 1)/24 = 0. 14 + 22/3 = 64/3.
  Bench bench;
  const int16_t product = bench.sums->add(0, 1);
  bench.sums->finish_plan();
  for (int i = 0; i < kFrameStride; ++i) bench.frame->raw[0][i] = bench.frame->raw[1][i] = i - kLeadIn;
  bench.sums->start(*bench.frame, kLeadIn);
  bench.sums->add_block(*bench.frame, kLeadIn, kLeadIn + 4);
  const ProductSums::Sum closed = bench.sums->turn(product, *bench.frame, kLeadIn + 4);
  EXPECT_EQ(closed.sum, 14);
  EXPECT_EQ(closed.ends_times_24, 24 * 22 / 3);
  EXPECT_EQ(bench.sums->sum(product), 0);  // the next window's
}

TEST(ProductSums, OnePairOfColumnsIsSummedOnce) {
  Bench bench;
  EXPECT_EQ(bench.sums->add(5, 9), bench.sums->add(9, 5));
  EXPECT_NE(bench.sums->add(5, 9), bench.sums->add(5, 5));
}

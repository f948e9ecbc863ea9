// Long signals made small: hand-sized vectors with the answer beside them.
#include "host_sim/reports/figures/reduce.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace host_sim::reports;
using Values = std::vector<double>;

TEST(EnvelopeLine, AShortSignalIsKeptAsItIs) {
  const Curve curve = envelope_line({5, 6, 7, 8}, {1, 3}, 10.0, 0.5, 2);
  EXPECT_EQ(curve.x, (Values{10.5, 11.0, 11.5}));
  EXPECT_EQ(curve.y, (Values{6, 7, 8}));
}

// Two columns of four: 0 9 1 2 has its lowest (0) first, then 9; 3 4 -7 5 has 4 ... 5 as highest at the end, -7 before
// it.
TEST(EnvelopeLine, KeepsEveryPeakInItsOrder) {
  const Curve curve = envelope_line({0, 9, 1, 2, 3, 4, -7, 5}, {0, 8}, 0.0, 1.0, 2);
  EXPECT_EQ(curve.x, (Values{0, 1, 6, 7}));
  EXPECT_EQ(curve.y, (Values{0, 9, -7, 5}));
}

TEST(EnvelopeBand, SpansEachColumn) {
  const Curve curve = envelope_band({0, 9, 1, 2, 3, 4, -7, 5}, {0, 8}, 0.0, 1.0, 2);
  EXPECT_EQ(curve.x, (Values{1.5, 5.5}));
  EXPECT_EQ(curve.y, (Values{0, -7}));
  EXPECT_EQ(curve.y_high, (Values{9, 5}));
}

// Bins of x 0..1 and 1..2: five samples 1..5 (median 3, 10 % quantile 1, 90 % quantile 5) and four, which are too few.
TEST(Binned, MedianAndRangePerStep) {
  const Binned bins = binned({0, 0.1, 0.2, 0.3, 0.4, 1.5, 1.6, 1.7, 2.0}, {5, 1, 3, 2, 4, 8, 8, 8, 8}, 2);
  EXPECT_EQ(bins.x, (Values{0.5}));
  EXPECT_EQ(bins.median, (Values{3}));
  EXPECT_EQ(bins.low, (Values{1}));
  EXPECT_EQ(bins.high, (Values{5}));
}

TEST(Binned, NothingToSortByGivesNothing) {
  EXPECT_TRUE(binned({}, {}, 3).x.empty());
  EXPECT_TRUE(binned({1, 1, 1, 1, 1}, {1, 2, 3, 4, 5}, 3).x.empty());
}

// A sine of 50 samples a period over 1000 samples; the other differs in samples 600 to 649 only. Two cycles are 100
// samples (one more or less for the counting of crossings), and must contain these.
TEST(MostDifferent, FindsWhereTheSignalsPart) {
  Values a(1000), b;
  for (size_t i = 0; i < a.size(); ++i) a[i] = std::sin(2 * M_PI * static_cast<double>(i) / 50.0);
  b = a;
  for (size_t i = 600; i < 650; ++i) b[i] += 1.0;
  const Span span = most_different(a, b, 2.0);
  EXPECT_NEAR(static_cast<double>(span.count), 100.0, 6.0);
  EXPECT_LE(span.first, 600u);
  EXPECT_GE(span.first + span.count, 650u);
}

TEST(MostDifferent, WithoutASecondSignalItIsTheStart) {
  EXPECT_EQ(most_different(Values(500, 1.0), {}, 3.0).first, 0u);
}

}  // namespace

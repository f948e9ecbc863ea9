// Sums of filters, worked out by hand.
#include "firmware/conditioning/filter_sum.hpp"

#include <gtest/gtest.h>

#include <vector>

using namespace firmware;

namespace {

std::vector<Tap> taps(std::initializer_list<int> values) {
  std::vector<Tap> result;
  for (int value : values) result.push_back(Tap::from_raw(value));
  return result;
}
std::vector<Code> codes(std::initializer_list<int> values) {
  std::vector<Code> result;
  for (int value : values) result.push_back(Code::from_raw(value));
  return result;
}

// 5 (1 + 9) + 2 (4 + 7) + 3 * 6 = 50 + 22 + 18 = 90; odd: 5 (9 - 1) + 2 (7 - 4) = 46.
TEST(FilterSum, EvenAndOddByHand) {
  const auto x = codes({1, 4, 6, 7, 9});
  const auto even = taps({5, 2, 3, 2, 5}), odd = taps({-5, -2, 0, 2, 5});
  EXPECT_EQ(parity_of(even.data(), 2), 1);
  EXPECT_EQ(parity_of(odd.data(), 2), -1);
  EXPECT_EQ(parity_of(taps({1, 2, 3, 2, 5}).data(), 2), 0);
  for (int parity : {0, 1}) EXPECT_EQ(filter_sum(parity, even.data(), &x[2], 2), 90);
  for (int parity : {0, -1}) EXPECT_EQ(filter_sum(parity, odd.data(), &x[2], 2), 46);
  EXPECT_EQ(even_sum(even.data(), &x[2], 2), 90);
  EXPECT_EQ(odd_sum(odd.data(), &x[2], 2), 46);
}

// Filters without a four of taps on either side, with rounds of four alone, and with a rest. Samples 100 + n about n = 0, and S the sum
// of k^2 from 1 to h: taps of 1 give 100 (2 h + 1), odd taps of k the sum of 2 k^2 = 2 S, even taps of |k| give 100 h (h + 1).
// Taps of 1 but for the oldest, which is 3, are neither: 100 (2 h + 1) + 2 (100 - h).
TEST(FilterSum, EveryLength) {
  int squares = 0;
  for (int half = 1; half <= kFilterHalf; ++half) {
    squares += half * half;
    std::vector<Code> x;
    std::vector<Tap> ones, odd, even;
    for (int k = -half; k <= half; ++k) {
      x.push_back(Code::from_raw(100 + k));
      ones.push_back(Tap::from_raw(1));
      odd.push_back(Tap::from_raw(k));
      even.push_back(Tap::from_raw(k < 0 ? -k : k));
    }
    const Code* const middle = &x[static_cast<size_t>(half)];
    EXPECT_EQ(even_sum(ones.data(), middle, half), 100 * (2 * half + 1)) << half;
    EXPECT_EQ(even_sum(even.data(), middle, half), 100 * half * (half + 1)) << half;
    EXPECT_EQ(odd_sum(odd.data(), middle, half), 2 * squares) << half;
    ones.front() = Tap::from_raw(3);
    EXPECT_EQ(parity_of(ones.data(), half), 0);
    EXPECT_EQ(filter_sum(0, ones.data(), middle, half), 100 * (2 * half + 1) + 2 * (100 - half)) << half;
  }
}

// Taps of 30 bits on the largest codes: 57 products of 2^30 2^23 = 57 2^53, which takes the upper words of the sums.
TEST(FilterSum, LargestTapsAndCodes) {
  const std::vector<Tap> taps(2 * kFilterHalf + 1, Tap::from_raw(1 << 30));
  const std::vector<Code> x(2 * kFilterHalf + 1, Code::from_raw(-(1 << 23)));
  for (int parity : {0, 1})
    EXPECT_EQ(filter_sum(parity, taps.data(), &x[kFilterHalf], kFilterHalf), -(int64_t{2 * kFilterHalf + 1} << 53));
}

}  // namespace

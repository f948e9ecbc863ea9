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
  const OddAndEven both = odd_and_even_sum(odd.data(), even.data(), &x[2], 2);
  EXPECT_EQ(both.odd, 46);
  EXPECT_EQ(both.even, 90);
}

// Lengths 5 and 7 on either side: one round of four and a rest in each. Samples n, taps 1: sums of -5 .. 5 and -7 .. 7 about 100
// are 11 * 100 and 15 * 100; with taps of |k| the sums are 100 * 2 * 15 and 100 * 2 * 28.
TEST(FilterSum, TwoEvenFiltersOfDifferentLength) {
  std::vector<Code> x;
  for (int n = 0; n <= 14; ++n) x.push_back(Code::from_raw(93 + n));
  const std::vector<Tap> ones_5(11, Tap::from_raw(1)), ones_7(15, Tap::from_raw(1));
  const TwoEven ones = two_even_sums(ones_5.data(), 5, ones_7.data(), 7, &x[7]);
  EXPECT_EQ(ones.shorter, 1100);
  EXPECT_EQ(ones.longer, 1500);
  const auto size_5 = taps({5, 4, 3, 2, 1, 0, 1, 2, 3, 4, 5}),
             size_7 = taps({7, 6, 5, 4, 3, 2, 1, 0, 1, 2, 3, 4, 5, 6, 7});
  const TwoEven sizes = two_even_sums(size_5.data(), 5, size_7.data(), 7, &x[7]);
  EXPECT_EQ(sizes.shorter, 3000);
  EXPECT_EQ(sizes.longer, 5600);
}

}  // namespace

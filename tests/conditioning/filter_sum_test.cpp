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

// Displacement 5, velocity and acceleration 7 (then 9) taps on either side: rounds of four and a rest in each part. Samples n about
// 100: taps of 1 give 11 * 100; taps of |k| give 100 * 2 * 15 (of 28, of 45); taps of k give the sum of 2 k^2: 280 (570).
TEST(FilterSum, ThreeFiltersOfDifferentLength) {
  std::vector<Code> x;
  for (int n = -9; n <= 9; ++n) x.push_back(Code::from_raw(100 + n));
  for (const int half : {7, 9}) {
    std::vector<SignalConfiguration> signals(3);
    signals[0].half_length = 5;
    signals[1].half_length = signals[2].half_length = static_cast<uint8_t>(half);
    for (int k = -5; k <= 5; ++k) signals[0].tap[5 + k] = Tap::from_raw(1);
    for (int k = -half; k <= half; ++k) {
      signals[1].tap[half + k] = Tap::from_raw(k);
      signals[2].tap[half + k] = Tap::from_raw(k < 0 ? -k : k);
    }
    const ThreeSums sums = three_sums(signals.data(), &x[9]);
    EXPECT_EQ(sums.displacement, 1100);
    EXPECT_EQ(sums.velocity, half == 7 ? 280 : 570);
    EXPECT_EQ(sums.acceleration, half == 7 ? 5600 : 9000);
  }
}

}  // namespace

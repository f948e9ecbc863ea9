// Numbers of 31 bits against long double, at their edges, and by hand.
#include "firmware/fixed_point/short_scaled.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace firmware;

namespace {

long double value(ShortScaled s) { return std::ldexp(static_cast<long double>(s.mantissa), s.exponent); }
long double value(Scaled s) { return std::ldexp(static_cast<long double>(s.mantissa), s.exponent); }

ShortScaled random_number(std::mt19937_64& random) {
  return short_scaled(static_cast<int64_t>(random()) >> (random() % 60), static_cast<int32_t>(random() % 41) - 20);
}

}  // namespace

TEST(ShortScaled, ByHand) {
  EXPECT_EQ(value(short_scaled(3) + short_scaled(-5)), -2.0L);
  EXPECT_EQ(value(short_scaled(-3, -2)), -0.75L);
  EXPECT_EQ(value(short_scaled(0) + short_scaled(7)), 7.0L);
  EXPECT_EQ(value(short_scaled(7) + short_scaled(-7)), 0.0L);
  EXPECT_EQ(value(long_scaled(short_scaled(Scaled::ratio(-5, 8)))), -0.625L);
  // 2^32 - 1 has 32 bits: to nearest is 2^32 = 2^30 2^2.
  EXPECT_EQ(short_scaled((int64_t{1} << 32) - 1).mantissa, 1 << 30);
  EXPECT_EQ(short_scaled((int64_t{1} << 32) - 1).exponent, 2);
  EXPECT_EQ(value(short_scaled(INT64_MIN)), -0x1p63L);
}

TEST(ShortScaled, RoundsOnce) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100000; ++trial) {
    const int64_t whole = static_cast<int64_t>(random()) >> (random() % 64);
    const ShortScaled s = short_scaled(whole);
    EXPECT_TRUE(whole == 0 || std::abs(int64_t{s.mantissa}) >= 1 << 30) << whole;
    EXPECT_LE(std::fabs(value(s) - static_cast<long double>(whole)),
              std::ldexp(std::fabs(static_cast<long double>(whole)), -31));
    const ShortScaled a = random_number(random), b = random_number(random);
    // Aligned in 62 bits, then rounded: 2^-31 of the sum and 2^-61 of the larger one.
    const long double sum = value(a) + value(b), larger = std::max(std::fabs(value(a)), std::fabs(value(b)));
    EXPECT_LE(std::fabs(value(a + b) - sum), std::ldexp(std::fabs(sum), -31) + std::ldexp(larger, -60));
  }
}

// Products of 62 bits, each cut at 2^-62 2^5 of the largest: 20 of them are off by 20 such steps at the most.
TEST(ShortScaled, SumOfProductsIsNearlyExact) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 20000; ++trial) {
    const int count = static_cast<int>(random() % 21);
    std::vector<ShortScaled> a, b;
    long double sum = 0, largest = 0;
    for (int i = 0; i < count; ++i) {
      a.push_back(random_number(random)), b.push_back(random_number(random));
      sum += value(a[i]) * value(b[i]);
      largest = std::max(largest, std::fabs(value(a[i]) * value(b[i])));
    }
    const Scaled found = sum_in_two_passes(
        count, [&](int i) { return a[i]; }, [&](int i) { return b[i]; });
    EXPECT_LE(std::fabs(value(found) - sum), std::ldexp(largest, -51)) << count;
  }
}

TEST(ShortScaled, SumOfProductsAtItsEdges) {
  const auto all = [](ShortScaled one, int count) {
    return sum_in_two_passes(
        count, [&](int) { return one; }, [&](int) { return one; });
  };
  const ShortScaled largest{INT32_MAX, 0};
  EXPECT_TRUE(all(largest, 0).is_zero());
  EXPECT_TRUE(all(ShortScaled{}, 9).is_zero());
  // 4096 times (2^31 - 1)^2: 74 bits.
  const long double wanted = 4096.0L * INT32_MAX * INT32_MAX;
  EXPECT_LE(std::fabs(value(all(largest, 4096)) - wanted), std::ldexp(wanted, -40));
}

// A PC's way gives the bits of a board's way: also of zeros, of numbers too small to count beside the largest, of no numbers at all.
TEST(ShortScaled, SumOfKeptProductsHasTheSameBits) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 20000; ++trial) {
    const int count = static_cast<int>(random() % 41);
    std::vector<ShortScaled> a, b;
    for (int i = 0; i < count; ++i) {
      a.push_back(random_number(random)), b.push_back(random_number(random));
      a[i].exponent = static_cast<int16_t>(a[i].exponent + static_cast<int>(random() % 80) - 40);
      if (random() % 4 == 0) a[i] = ShortScaled{};
      if (random() % 8 == 0) b[i] = ShortScaled{0, static_cast<int16_t>(random() % 2000)};
    }
    const auto one = [&](int i) { return a[i]; };
    const auto other = [&](int i) { return b[i]; };
    const Scaled kept = sum_of_kept<40>(count, one, other), twice = sum_in_two_passes(count, one, other);
    ASSERT_EQ(kept.mantissa, twice.mantissa);
    ASSERT_EQ(kept.exponent, twice.exponent);
  }
}

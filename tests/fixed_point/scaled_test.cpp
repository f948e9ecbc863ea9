// Block-floating arithmetic against long double, at its edges, and by hand.
#include "firmware/fixed_point/scaled.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "firmware/fixed_point/whole_column.hpp"

using namespace firmware;

namespace {

long double value(Scaled s) { return std::ldexp(static_cast<long double>(s.mantissa), s.exponent); }

Scaled random_scaled(std::mt19937_64& random) {
  const int64_t mantissa = static_cast<int64_t>(random() >> (random() % 60)) >> 1;
  return Scaled::from_int(random() % 2 ? mantissa : -mantissa, static_cast<int32_t>(random() % 121) - 60);
}

// The long double itself rounds at 2^-64; the arithmetic promises 2^-59.
void expect_close(Scaled got, long double want, long double size) {
  EXPECT_LE(std::fabs(static_cast<double>(value(got) - want)), std::ldexp(static_cast<double>(std::fabs(size)), -59));
}

TEST(Scaled, TimesAWholeNumberHasTheBitsOfTheProduct) {
  uint64_t random = 7;
  const auto next = [&random] { return random = random * 6364136223846793005u + 1442695040888963407u; };
  for (int trial = 0; trial < 100000; ++trial) {
    const firmware::Scaled a = firmware::Scaled::from_int(static_cast<int64_t>(next()) / 4, -40);
    const int64_t n = (static_cast<int64_t>(next()) / 4) >> (next() >> 58);
    const firmware::Scaled wanted = a * firmware::Scaled::from_int(n), found = times(a, n);
    ASSERT_EQ(found.mantissa, wanted.mantissa) << n;
    ASSERT_EQ(found.exponent, wanted.exponent) << n;
  }
  EXPECT_TRUE(times(firmware::Scaled::from_int(3), 0).is_zero());
}

// From the smallest to the largest, each before all that follow: signs, exponents, mantissas, and the two neighbours 2^62 - 1
// and 2^62, whose difference is one part in 2^62.
// A number is handed over as 32 bits only where its type fits them.
TEST(Scaled, WholeNumbersOfEveryWidth) {
  EXPECT_EQ(value(Scaled::from_int(UINT32_MAX)), 4294967295.0L);
  EXPECT_EQ(value(Scaled::from_int(INT32_MIN)), -2147483648.0L);
  EXPECT_EQ(value(Scaled::from_int(int64_t{1} << 40)), 1099511627776.0L);
  EXPECT_EQ(value(Scaled::from_int(uint16_t{65535})), 65535.0L);
  EXPECT_EQ(value(Scaled::from_int(int8_t{-128})), -128.0L);
  EXPECT_EQ(value(Scaled::ratio(UINT32_MAX, 2)), 2147483647.5L);
  EXPECT_EQ(value(Scaled::ratio(1, int64_t{1} << 40)), 1.0L / 1099511627776.0L);
  EXPECT_EQ(value(Scaled::ratio(-3, 4)), -0.75L);
}

// In place, also with the number itself on the other side.
TEST(Scaled, InPlaceByHand) {
  Scaled a = Scaled::from_int(6);
  a += Scaled::from_int(4);
  EXPECT_EQ(value(a), 10);
  a -= Scaled::from_int(3);
  EXPECT_EQ(value(a), 7);
  a *= a;
  EXPECT_EQ(value(a), 49);
  a += a;
  EXPECT_EQ(value(a), 98);
  a /= Scaled::from_int(7);
  EXPECT_EQ(value(a), 14);
  a -= a;
  EXPECT_TRUE(a.is_zero());
}

TEST(Scaled, ComparesExactly) {
  constexpr int64_t kSmallest = int64_t{1} << 61, kLargest = (int64_t{1} << 62) - 1;
  const Scaled rising[] = {{-kSmallest, 1}, {-kLargest, 0}, {-kSmallest - 1, 0}, {-kSmallest, 0}, {-kLargest, -90}, {},
                           {kLargest, -90}, {kSmallest, 0}, {kSmallest + 1, 0},  {kLargest, 0},   {kSmallest, 1}};
  for (const Scaled& a : rising)
    for (const Scaled& b : rising) {
      EXPECT_EQ(a < b, &a < &b);
      EXPECT_EQ(a >= b, &a >= &b);
    }
}

}  // namespace

TEST(Scaled, ByHand) {
  EXPECT_EQ(value(Scaled::from_int(3) + Scaled::from_int(-5)), -2.0L);
  EXPECT_EQ(value(Scaled::from_int(-3) * Scaled::from_int(7)), -21.0L);
  EXPECT_EQ(value(Scaled::ratio(-3, 4)), -0.75L);
  EXPECT_EQ(value(sqrt(Scaled::from_int(144))), 12.0L);
  EXPECT_EQ(value(sqrt(Scaled::ratio(1, 16))), 0.25L);
  EXPECT_TRUE(sqrt(Scaled::from_int(-1)).is_zero());
  EXPECT_EQ(to_fixed(Scaled::ratio(5, 2), 0), 3);  // halves away from zero
  EXPECT_EQ(to_fixed(Scaled::ratio(-5, 2), 0), -3);
  EXPECT_EQ(to_fixed(Scaled::ratio(1, 3), 16), 21845);                      // 65536 / 3 = 21845.33
  EXPECT_EQ(to_fixed(Scaled::from_int(1, 80), 0), (int64_t{1} << 62) - 1);  // saturates
  EXPECT_EQ(to_fixed(Scaled::from_int(1, -80), 0), 0);
  EXPECT_EQ(log2_floor(Scaled::from_int(8)), 3);
  EXPECT_EQ(log2_floor(Scaled::ratio(1, 3)), -2);
}

TEST(Scaled, KeepsItsNormalForm) {
  for (int64_t v : {int64_t{1}, int64_t{-1}, INT64_MAX, INT64_MIN, (int64_t{1} << 62), (int64_t{1} << 62) - 1}) {
    const Scaled s = Scaled::from_int(v);
    const uint64_t magnitude = static_cast<uint64_t>(s.mantissa < 0 ? -s.mantissa : s.mantissa);
    EXPECT_GE(magnitude, uint64_t{1} << 61);
    EXPECT_LT(magnitude, uint64_t{1} << 62);
    EXPECT_NEAR(static_cast<double>(value(s)), static_cast<double>(v),
                std::ldexp(std::fabs(static_cast<double>(v)), -52));
  }
}

TEST(Scaled, AgreesWithLongDouble) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 100000; ++i) {
    const Scaled a = random_scaled(random), b = random_scaled(random);
    const long double x = value(a), y = value(b);
    expect_close(a + b, x + y, std::fmax(std::fabs(x), std::fabs(y)));
    expect_close(a - b, x - y, std::fmax(std::fabs(x), std::fabs(y)));
    expect_close(a * b, x * y, x * y);
    if (!b.is_zero()) expect_close(a / b, x / y, x / y);
    expect_close(sqrt(abs(a)), std::sqrt(std::fabs(x)), std::sqrt(std::fabs(x)));
    EXPECT_EQ(a < b, x < y);
    EXPECT_EQ(a == b, x == y);
  }
}

TEST(Scaled, DivisionByZeroAndOverflowGiveTheLargestValue) {
  const Scaled huge = Scaled::from_int(1) / Scaled{};
  EXPECT_GT(log2_floor(huge), 1 << 20);
  EXPECT_TRUE((Scaled::from_int(-1) / Scaled{}).is_negative());
  EXPECT_TRUE((Scaled::from_int(0) / Scaled{}).is_zero());
}

// 2^-100 to 20 bits with its sign: 2^19 times 2^-119. A zero stands at exponent 0, far above it, and drops no bits (a shift by
// less than nothing, which the sanitizer alone shows).
TEST(WholeColumn, AZeroBesideSmallNumbers) {
  const Scaled numbers[] = {Scaled::from_int(1, -100), Scaled{}, Scaled::from_int(-1, -101)};
  int32_t column[3];
  EXPECT_EQ(round_to_column(numbers, 3, 20, column), -119);
  EXPECT_EQ(column[0], 1 << 19);
  EXPECT_EQ(column[1], 0);
  EXPECT_EQ(column[2], -(1 << 18));
}

// Block-floating to decimal: by hand, and against long double (64 bits of mantissa) over the range of all rigs.
#include "firmware/can_protocol/values/decimal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "firmware/can_protocol/streams/estimate_frames.hpp"

namespace firmware {
namespace {

constexpr int64_t kInt32 = 2147483647;

void expect_decimal(Scaled value, int64_t mantissa, int32_t exponent) {
  const Decimal decimal = to_decimal(value, kInt32, -24, 7);
  EXPECT_EQ(decimal.mantissa, mantissa);
  EXPECT_EQ(decimal.exponent, exponent);
}

TEST(ToDecimal, ByHand) {
  expect_decimal(Scaled(), 0, -24);
  expect_decimal(Scaled::from_int(1), 1000000000, -9);  // 2^31 > 1000000000, but not 10000000000
  expect_decimal(Scaled::from_int(-1), -1000000000, -9);
  expect_decimal(Scaled::from_int(1000000000), 1000000000, 0);
  expect_decimal(Scaled::ratio(5, 1000000), 500000000, -14);    // 5e-6 = 5e8 e-14
  expect_decimal(Scaled::ratio(1, 3), 333333333, -9);           // 3333333333 is above 2^31 - 1
  expect_decimal(Scaled::from_int(2147483647), 2147483647, 0);  // the last that fits
  expect_decimal(Scaled::from_int(2147483648), 214748365, 1);   // rounded: ...64.8
  // 2147483647.4 rounds down to what fits, 2147483647.5 does not: 214748364.75 rounds to 214748365.
  expect_decimal(Scaled::ratio(21474836474, 10), 2147483647, 0);
  expect_decimal(Scaled::ratio(4294967295, 2), 214748365, 1);
  // Halves go away from zero: 0.5 in units of 1 with the exponent held at 0.
  EXPECT_EQ(decimal_mantissa(Scaled::ratio(1, 2), 0, kInt32), 1);
  EXPECT_EQ(decimal_mantissa(Scaled::ratio(-1, 2), 0, kInt32), -1);
  EXPECT_EQ(decimal_mantissa(Scaled::ratio(-3, 2), 0, kInt32), -2);
}

TEST(ToDecimal, EndsOfTheRange) {
  expect_decimal(Scaled::from_int(3, 200), kInt32, 7);  // 4.8e60: saturates
  expect_decimal(Scaled::from_int(-3, 200), -kInt32, 7);
  expect_decimal(Scaled::from_int(1, 1 << 19), kInt32, 7);
  expect_decimal(Scaled::from_int(1, -300), 0, -24);  // 5e-91: nothing left
  expect_decimal(Scaled::from_int(1, -(1 << 19)), 0, -24);
  expect_decimal(Scaled::ratio(1, 1000000000000000000), 1000000, -24);  // 1e-18: below full resolution, still exact
}

TEST(ToDecimal, AgreesWithLongDoubleFrom5em6To1e9) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20000; ++i) {
    // A 62-bit mantissa and a binary exponent: 2^-18 = 3.8e-6 up to 2^30 = 1.1e9.
    const int64_t mantissa = (int64_t{1} << 61) + static_cast<int64_t>(random() >> 3);
    const int32_t exponent = -79 + static_cast<int32_t>(random() % 48);
    const bool negative = (random() & 1) != 0;
    const long double value = std::ldexp(static_cast<long double>(mantissa), exponent) * (negative ? -1 : 1);
    const Decimal decimal = to_decimal(Scaled::from_int(negative ? -mantissa : mantissa, exponent), kInt32, -24, 7);
    const long double exact = value / std::pow(10.0L, static_cast<long double>(decimal.exponent));
    ASSERT_LE(std::fabs(static_cast<long double>(decimal.mantissa) - exact), 0.5L + 1e-6L)
        << static_cast<double>(value);
    ASSERT_LE(std::llabs(decimal.mantissa), kInt32);
    ASSERT_GT(std::fabs(exact) * 10, kInt32);  // one digit more would not fit
    ASSERT_LE(std::fabs(static_cast<long double>(decimal.mantissa) / exact - 1), 1e-7L);
    // And back.
    const Scaled again = from_decimal(decimal);
    const long double back = std::ldexp(static_cast<long double>(again.mantissa), again.exponent);
    ASSERT_LE(std::fabs(back / value - 1), 1e-7L);
  }
}

double in_double(Scaled value) { return std::ldexp(static_cast<double>(value.mantissa), value.exponent); }

TEST(EstimateRecord, KeepsValueAndStandardDeviation) {
  // value, std, both as ratios of integers; how far each may be off, relative.
  struct Case {
    Scaled value, std;
    double value_tolerance, std_tolerance;
  };
  const Case cases[] = {
      {Scaled::ratio(5, 1000000), Scaled::ratio(1, 100000000), 3e-9, 1e-4},  // the smallest rig
      {Scaled::from_int(1000000000), Scaled::from_int(12345), 3e-9, 1e-4},   // the largest
      {Scaled::from_int(20), Scaled::ratio(1, 1000000), 3e-9, 1e-3},         // std 5e-8 of the value: 1000e-9
      {Scaled::from_int(20), Scaled::from_int(2000000), 3e-9, 1e-4},         // std 1e5 times the value
      {Scaled(), Scaled::ratio(3, 10), 0, 1e-4},                             // a value of 0 lifts its exponent
      {Scaled::ratio(1, 1000000000000), Scaled::from_int(100), 1, 1e-4},     // far below its std: std wins
  };
  for (const Case& c : cases) {
    ParameterEstimate estimate;
    estimate.value = c.value;
    estimate.std = c.std;
    const EstimateRecord record = estimate_record(estimate, 5);
    EXPECT_NEAR(in_double(record_value(record)), in_double(c.value), c.value_tolerance * std::fabs(in_double(c.value)));
    EXPECT_NEAR(in_double(record_std(record)), in_double(c.std), c.std_tolerance * in_double(c.std));
  }
}

TEST(EstimateRecord, AStandardDeviationBeyondAllBoundsSaturates) {
  ParameterEstimate estimate;
  estimate.value = Scaled::from_int(1);
  estimate.std = Scaled::from_int(1, 500);
  const EstimateRecord record = estimate_record(estimate, 0);
  EXPECT_EQ(record.std, 65535);
  EXPECT_EQ(record.exponent + record.std_exponent, 22);  // 65535e22: the largest there is
}

}  // namespace
}  // namespace firmware

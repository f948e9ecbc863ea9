// Division and square root are exact: each quotient and root is held against its definition in 128-bit integers.
#include "firmware/fixed_point/wide.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace firmware;

namespace {

using Integer = unsigned __int128;
constexpr uint64_t kOne = 1;

// quotient = floor(n 2^62 / d) means  quotient d <= n 2^62 < (quotient + 1) d.
void expect_quotient(uint64_t numerator, uint64_t denominator) {
  const Integer dividend = static_cast<Integer>(numerator) << 62;
  for (const auto divide : {divide_fraction, divide_by_steps}) {
    const Integer quotient = divide(numerator, denominator);
    ASSERT_TRUE(quotient * denominator <= dividend && dividend < (quotient + 1) * denominator)
        << numerator << " / " << denominator;
  }
}

// The nearest root r of s has  r^2 - r < s <= r^2 + r  (half way between two roots lies no whole number).
void expect_root(uint64_t radicand) {
  const Integer root = nearest_root(radicand), square = static_cast<Integer>(radicand) << 56;
  ASSERT_TRUE(root * root - root < square && square <= root * root + root) << radicand;
}

}  // namespace

TEST(Wide, ByHand) {
  // (2^61 / 2^62) 2^62 = 2^61; (3 2^60 / 2^62) 2^62 = 3 2^60; just under 1: 2^62 - 2^62 / (2^63 - 1) rounds down to 2^62 - 1.
  EXPECT_EQ(divide_fraction(kOne << 61, kOne << 62), kOne << 61);
  EXPECT_EQ(divide_fraction(3 * (kOne << 60), kOne << 62), 3 * (kOne << 60));
  EXPECT_EQ(divide_fraction((kOne << 63) - 2, (kOne << 63) - 1), (kOne << 62) - 1);
  EXPECT_EQ(divide_fraction(0, kOne << 62), 0u);
  EXPECT_EQ(nearest_root(kOne << 62), kOne << 59);                         // sqrt(2^118)
  EXPECT_EQ(nearest_root(9 * (kOne << 60)), 3 * (kOne << 58));             // sqrt(9 2^116)
  EXPECT_EQ(nearest_root(~uint64_t{0}), kOne << 60);                       // sqrt(2^120 - 2^56) = 2^60 - 2^-5
  EXPECT_EQ(multiply(~uint64_t{0}, ~uint64_t{0}).high, ~uint64_t{0} - 1);  // (2^64 - 1)^2 = 2^128 - 2^65 + 1
  EXPECT_EQ(multiply(~uint64_t{0}, ~uint64_t{0}).low, 1u);
}

TEST(Wide, QuotientsAreExact) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 2000000; ++i) {
    const uint64_t denominator = (kOne << 61) + random() % (3 * (kOne << 61));
    expect_quotient(random() % denominator, denominator);
  }
}

TEST(Wide, QuotientsAreExactAtTheEdges) {
  std::mt19937_64 random(12);
  for (uint64_t step = 0; step < 20000; ++step) {
    for (uint64_t denominator :
         {(kOne << 61) + step, (kOne << 62) - 1 - step, (kOne << 62) + step, (kOne << 63) - 1 - step}) {
      expect_quotient(denominator - 1 - step, denominator);
      expect_quotient(denominator / 2 + step, denominator);
      // A dividend just at and just under a whole multiple: where a floor goes wrong first.
      const Integer multiple = (random() >> 2) * static_cast<Integer>(denominator) >> 62;
      const uint64_t near = static_cast<uint64_t>(multiple) % denominator;
      expect_quotient(near, denominator);
      expect_quotient((near + 1) % denominator, denominator);
    }
  }
}

TEST(Wide, RootsAreTheNearest) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 2000000; ++i) expect_root(random() | (kOne << 62));
}

TEST(Wide, RootsAreTheNearestAtTheEdges) {
  for (uint64_t step = 0; step < 100000; ++step)
    for (uint64_t radicand : {(kOne << 62) + step, (kOne << 63) - 1 - step, (kOne << 63) + step, ~uint64_t{0} - step})
      expect_root(radicand);
  // Squares of whole numbers with a neighbour to either side: (2^31 + k)^2 has 62 or 63 bits.
  for (uint64_t k = 0; k < 100000; ++k) {
    const uint64_t side = (kOne << 31) + k * 21474;
    for (uint64_t radicand : {side * side - (k > 0), side * side, side * side + 1}) expect_root(radicand);
  }
}

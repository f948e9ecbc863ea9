// The fixed-point sine against the library's.
#include "firmware/excitation/sine.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

constexpr double kTurn = 4294967296.0;
constexpr double kFullScale = 2147483648.0;

double error_at(uint32_t phase) {
  return firmware::sine(phase).raw / kFullScale - std::sin(2.0 * M_PI * phase / kTurn);
}

TEST(Sine, WorstErrorOverTheWholeTurnIsBelowTheStatedBound) {
  double worst = 0.0;
  for (uint64_t phase = 0; phase < (uint64_t{1} << 32); phase += 65521) {
    worst = std::max(worst, std::fabs(error_at(static_cast<uint32_t>(phase))));
  }
  EXPECT_LT(worst, 2e-8);  // stated in sine.hpp; the issue asks for 1e-6
}

TEST(Sine, CornersOfTheFold) {
  for (uint32_t corner : {0u, 0x40000000u, 0x80000000u, 0xC0000000u}) {
    for (int32_t offset = -3; offset <= 3; ++offset) {
      EXPECT_LT(std::fabs(error_at(corner + static_cast<uint32_t>(offset))), 2e-8) << corner << " " << offset;
    }
  }
}

TEST(Sine, HandSizedValues) {
  EXPECT_EQ(firmware::sine(0).raw, 0);
  EXPECT_EQ(firmware::sine(0x80000000u).raw, 0);
  EXPECT_NEAR(firmware::sine(0x40000000u).raw, 2147483647, 43);           // sin 90 deg = 1
  EXPECT_NEAR(firmware::sine(0xC0000000u).raw, -2147483647, 43);          // sin 270 deg = -1
  EXPECT_NEAR(firmware::sine(0xFFFFFFFFu / 12 + 1).raw, 1073741824, 43);  // sin 30 deg = 1/2
  EXPECT_NEAR(firmware::cosine(0).raw, 2147483647, 43);
}

TEST(Sine, IsOdd) {
  for (uint32_t phase = 1; phase < 0x7FFFFFFFu - 1234577u; phase += 1234577u) {
    EXPECT_NEAR(firmware::sine(phase).raw, -firmware::sine(0u - phase).raw, 1);
  }
}

}  // namespace

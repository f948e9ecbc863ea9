// The bits of a float from integers: by hand, then against the processor's own conversion of an exact long double.
#include "firmware/can_protocol/values/single_precision.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/streams/estimate_frames.hpp"

namespace firmware {
namespace {

TEST(SinglePrecision, ByHand) {
  EXPECT_EQ(single_precision_bits(Scaled()), 0u);
  EXPECT_EQ(single_precision_bits(Scaled::from_int(1)), 0x3F800000u);   // exponent field 127
  EXPECT_EQ(single_precision_bits(Scaled::from_int(-2)), 0xC0000000u);  // sign, exponent field 128
  EXPECT_EQ(single_precision_bits(Scaled::from_int(20)), 0x41A00000u);  // 1.25 * 2^4: fraction 0.25 = 0x200000
  EXPECT_EQ(single_precision_bits(Scaled::ratio(1, 10)), 0x3DCCCCCDu);  // 0.0001100110011..., rounded up at the end
  // Halves go to the even neighbour: 2^24 + 1 lies between 2^24 and 2^24 + 2, 2^24 + 3 between ... + 2 and ... + 4.
  EXPECT_EQ(single_precision_bits(Scaled::from_int((1 << 24) + 1)), 0x4B800000u);
  EXPECT_EQ(single_precision_bits(Scaled::from_int((1 << 24) + 3)), 0x4B800002u);
  // A carry through all places: 2^24 - 1/2 - a little rounds down, 2^25 - 1 rounds up to 2^25 (exponent field 152).
  EXPECT_EQ(single_precision_bits(Scaled::from_int((1 << 25) - 1)), 0x4C000000u);
}

TEST(SinglePrecision, EndsOfTheRange) {
  EXPECT_EQ(single_precision_bits(Scaled::from_int(0xFFFFFF, 104)), 0x7F7FFFFFu);   // the largest
  EXPECT_EQ(single_precision_bits(Scaled::from_int(0x1FFFFFF, 103)), 0x7F800000u);  // half a place more: infinity
  EXPECT_EQ(single_precision_bits(Scaled::from_int(0x1FFFFFE, 103)), 0x7F7FFFFFu);  // the same as the largest
  EXPECT_EQ(single_precision_bits(Scaled::from_int(-1, 1 << 19)), 0xFF800000u);
  EXPECT_EQ(single_precision_bits(Scaled::from_int(1, -126)), 0x00800000u);          // the smallest normal
  EXPECT_EQ(single_precision_bits(Scaled::from_int(0x1FFFFFF, -151)), 0x00800000u);  // carries into it
  EXPECT_EQ(single_precision_bits(Scaled::from_int(1, -149)), 0x00000001u);          // the smallest of all
  EXPECT_EQ(single_precision_bits(Scaled::from_int(1, -150)), 0x00000000u);          // half of it: to the even 0
  EXPECT_EQ(single_precision_bits(Scaled::from_int(3, -151)), 0x00000001u);          // three quarters of it
  EXPECT_EQ(single_precision_bits(Scaled::from_int(-1, -(1 << 19))), 0x80000000u);   // minus zero
}

// A long double has 64 bits of mantissa and exponents to +-16383: the Scaled is exact in it, and its conversion to
// float rounds once, to the nearest even.
TEST(SinglePrecision, AgreesWithTheProcessor) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 400000; ++i) {
    // One in four has only 25 significant bits, so that exact halves occur; exponents from beyond both ends.
    int64_t mantissa = (int64_t{1} << 61) + static_cast<int64_t>(random() >> 3);
    if (i % 4 == 0) mantissa &= ~((int64_t{1} << 37) - 1);
    const int32_t exponent = -61 + static_cast<int32_t>(random() % 300) - 160;
    const int64_t with_sign = (random() & 1) != 0 ? -mantissa : mantissa;
    const auto expected = static_cast<float>(std::ldexp(static_cast<long double>(with_sign), exponent));
    uint32_t bits = 0;
    std::memcpy(&bits, &expected, sizeof bits);
    ASSERT_EQ(single_precision_bits(Scaled::from_int(with_sign, exponent)), bits) << with_sign << " " << exponent;
  }
}

TEST(FloatEstimate, HoldsValueAndStandardDeviation) {
  ParameterEstimate estimate;
  estimate.value = Scaled::from_int(-20);
  estimate.std = Scaled::ratio(1, 4);  // 2^-2: exponent field 125
  estimate.status = EstimateStatus::kValid;
  const CanFrame message = pack_estimate_float(1, 0, estimate);
  EXPECT_EQ(message.id, 0x590u);
  ASSERT_EQ(message.length, 8);
  const uint8_t expected[] = {0x00, 0x00, 0xA0, 0xC1, 0x00, 0x00, 0x80, 0x3E};
  EXPECT_EQ(std::memcmp(message.data, expected, sizeof expected), 0);
}

TEST(FloatEstimate, IsNotANumberWhereNothingWasEstimated) {
  for (const EstimateStatus status :
       {EstimateStatus::kStale, EstimateStatus::kNoExcitation, EstimateStatus::kSaturated}) {
    ParameterEstimate estimate;
    estimate.status = status;
    const CanFrame message = pack_estimate_float(1, 0, estimate);
    EXPECT_EQ(can::get_raw(message, can::kEstimateFloatSignals[0]), 0x7FC00000);
    EXPECT_EQ(can::get_raw(message, can::kEstimateFloatSignals[1]), 0x7FC00000);
  }
  Estimates estimates;
  estimates.unknown_count = 1;
  estimates.parameters[0].value = Scaled::from_int(1);
  estimates.parameters[0].status = EstimateStatus::kSkewed;
  const CanFrame fd = pack_estimates_float_fd(2, 0, estimates);
  EXPECT_EQ(fd.id, 0x340u);
  EXPECT_EQ(can::get_raw(fd, can::kEstimateFloatSignals[0]), 0x3F800000);
  EXPECT_EQ(can::get_raw(fd, can::kEstimateFloatSignals[1], 64), 0x7FC00000);  // there is no second estimate
}

// A classic frame of 8 bytes takes at most 135 bits, 270 us at 500 kbit/s; so in 50 ms, 30 % are 55 frames: the window
// and 27 estimates twice. 48 estimates need 97 frames, 26.2 ms of 87.3 ms.
TEST(FloatEstimate, IsSentWhereTheBusHasRoom) {
  EXPECT_TRUE(float_estimates_fit(27, 50000, false));
  EXPECT_FALSE(float_estimates_fit(28, 50000, false));
  EXPECT_FALSE(float_estimates_fit(48, 87000, false));
  EXPECT_TRUE(float_estimates_fit(48, 88000, false));
  EXPECT_TRUE(float_estimates_fit(48, 50000, true));
  EXPECT_FALSE(float_estimates_fit(1, 0, false));
}

}  // namespace
}  // namespace firmware

// IIO without a buffer: samples that are read one by one, commands to a converter, and codes.
#include "hal/linux/iio/iio_direct_source.hpp"
#include "hal/linux/iio/iio_drive_output.hpp"
#include "tests/hal/iio_device.hpp"

namespace {

using firmware::Quantity;
using hal::SampleResult;
using iio_test::IioDevice;
using iio_test::TestClock;

TEST_F(IioDevice, SingleReadsFollowTheClockWithoutDrift) {
  put("iio:device1/in_voltage0_raw", "80\n");
  put("iio:device1/in_voltage1_raw", "-12\n");
  TestClock clock;
  clock.time_ns = 700;
  hal::IioDirectSource source(clock);
  ASSERT_EQ(source.open({"iio:device1", 1000.0}, channels_, roots_), "");
  firmware::RawSample sample;
  ASSERT_EQ(source.read(sample), SampleResult::kSample);
  EXPECT_EQ(sample.sequence, 0u);
  EXPECT_EQ(sample.code[2][1], 80);
  EXPECT_EQ(sample.code[0][0], -12);
  EXPECT_EQ(source.read(sample), SampleResult::kNone);
  clock.time_ns = 1000699;
  EXPECT_EQ(source.read(sample), SampleResult::kNone);
  clock.time_ns = 1300000;  // 0.3 ms late: no effect on the next
  put("iio:device1/in_voltage0_raw", "85\n");
  ASSERT_EQ(source.read(sample), SampleResult::kSample);
  EXPECT_EQ(sample.sequence, 1u);
  EXPECT_EQ(sample.code[2][1], 85);
  clock.time_ns = 2000700;
  ASSERT_EQ(source.read(sample), SampleResult::kSample);
  EXPECT_EQ(sample.sequence, 2u);
  clock.time_ns = 5100000;  // two periods slept through
  ASSERT_EQ(source.read(sample), SampleResult::kSample);
  EXPECT_EQ(sample.sequence, 5u);
}

// Values of 32 bits without sign, whose upper 24 count, and a driver that tells nothing: what does not fit stands at its end.
TEST_F(IioDevice, SingleReadsClampWhatDoesNotFit) {
  put("iio:device1/in_voltage0_raw", "4294967295\n");
  put("iio:device1/in_voltage1_raw", "-99999999999\n");
  put("iio:device1/scan_elements/in_voltage0_type", "le:u32/32>>0");
  hal::IioDirectSource source(clock_);
  ASSERT_EQ(source.open({"adc16", 1000.0}, channels_, roots_), "");
  firmware::RawSample sample;
  ASSERT_EQ(source.read(sample), SampleResult::kSample);
  EXPECT_EQ(sample.code[2][1], 16777215);
  EXPECT_EQ(sample.code[0][0], INT32_MIN);
  ASSERT_TRUE(source.range(2, Quantity::kDisplacement));
  EXPECT_EQ(source.range(2, Quantity::kDisplacement)->highest, 16777215);
  EXPECT_FALSE(source.range(0, Quantity::kForce));
}

TEST_F(IioDevice, SingleReadsSayWhatIsWrong) {
  TestClock clock;
  hal::IioDirectSource source(clock);
  EXPECT_NE(source.open({"adc16", 1000.0}, channels_, roots_).find("in_voltage1_raw"), std::string::npos);
  put("iio:device1/in_voltage0_raw", "broken\n");
  put("iio:device1/in_voltage1_raw", "1\n");
  hal::IioDirectSource broken(clock);
  ASSERT_EQ(broken.open({"adc16", 1000.0}, channels_, roots_), "");
  firmware::RawSample sample;
  EXPECT_EQ(broken.read(sample), SampleResult::kFault);
}

// zero 2048 and full scale 2047: drive 0 -> 2048, -1 -> 1, 0.5 -> 2048 + 1023.5 rounded up = 3072, 1 - 2^-31 -> 4095.
TEST_F(IioDevice, DriveBecomesAConverterCode) {
  const struct {
    int32_t drive_q31;
    const char* code;
  } commands[] = {{0, "2048"}, {INT32_MIN, "1"}, {1 << 30, "3072"}, {INT32_MAX, "4095"}};
  for (const auto& command : commands) {
    put("iio:device1/out_voltage0_raw", "");
    hal::IioDriveOutput drive;
    ASSERT_EQ(drive.open({"adc16", "out_voltage0", 2048, 2047}, roots_), "");
    EXPECT_TRUE(drive.write(command.drive_q31));
    EXPECT_EQ(get("out_voltage0_raw"), command.code);
  }
  hal::IioDriveOutput missing;
  EXPECT_NE(missing.open({"adc16", "out_voltage5", 0, 1}, roots_), "");
  EXPECT_FALSE(missing.write(0));
}

// The converter of the emulated AST2600 board, through the kernel's driver: ten bits, each conversion a little higher
// than the one before.
TEST(OnConverter, SamplesComeThroughTheDriver) {
  if (hal::find_iio_device({}, "ast2600-adc0").empty()) GTEST_SKIP() << "this machine has no ast2600-adc0";
  TestClock clock;
  hal::IioDirectSource source(clock);
  ASSERT_EQ(source.open({"ast2600-adc0", 1000.0}, {{"in_voltage0", 0, Quantity::kForce}}), "");
  firmware::RawSample first, second;
  ASSERT_EQ(source.read(first), SampleResult::kSample);
  clock.time_ns = 1000000;
  ASSERT_EQ(source.read(second), SampleResult::kSample);
  EXPECT_GT(first.code[0][0], 0);
  EXPECT_GT(second.code[0][0], first.code[0][0]);
  EXPECT_LT(second.code[0][0], 1024);
  hal::IioBufferSource buffered(clock);
  EXPECT_NE(buffered.open({"ast2600-adc0", "", 1000.0, 64}, {{"in_voltage0", 0, Quantity::kForce}}).find("iio_direct"),
            std::string::npos);
}

TEST(IioCode, WideSamplesAreRoundedToTheirUpper24Bits) {
  const auto type = [](bool is_signed, uint8_t bits) {
    hal::ScanType result;
    result.is_signed = is_signed;
    result.bits = bits;
    return result;
  };
  EXPECT_EQ(hal::code_of(-8388608, type(true, 24)), -8388608);
  EXPECT_EQ(hal::code_of(INT32_MIN, type(true, 32)), -8388608);
  EXPECT_EQ(hal::code_of(0x7FFFFFFF, type(true, 32)), 8388607);
  EXPECT_EQ(hal::code_of(-1, type(true, 16)), -1);
  EXPECT_EQ(hal::code_of(16777215, type(false, 24)), 16777215);
  EXPECT_EQ(hal::code_of(0xFFFFFFFF, type(false, 32)), 16777215);
  EXPECT_EQ(hal::code_of(70000, type(false, 16)), 65535);
  // 127 / 256 and 128 / 256 of a code, of either sign; 64 bits: half of 2^40 below a code.
  EXPECT_EQ(hal::code_of(127, type(true, 32)), 0);
  EXPECT_EQ(hal::code_of(128, type(true, 32)), 1);
  EXPECT_EQ(hal::code_of(-128, type(true, 32)), 0);
  EXPECT_EQ(hal::code_of(-129, type(true, 32)), -1);
  EXPECT_EQ(hal::code_of((int64_t{5} << 40) + (int64_t{1} << 39), type(true, 64)), 6);
  EXPECT_EQ(hal::code_of(INT64_MAX, type(true, 64)), 8388607);
  EXPECT_EQ(hal::code_of(INT64_MIN, type(true, 64)), -8388608);
}

}  // namespace

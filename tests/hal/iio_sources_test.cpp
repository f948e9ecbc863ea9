// Samples that an IIO driver buffers.
#include "hal/linux/iio/iio_buffer_source.hpp"
#include "tests/hal/iio_device.hpp"

namespace {

using firmware::Quantity;
using hal::SampleResult;
using iio_test::IioDevice;
using iio_test::TestClock;

TEST_F(IioDevice, BufferedSamplesArriveOnTheirChannels) {
  add_buffer();
  hal::IioBufferSource source(clock_);
  ASSERT_EQ(source.open({"adc16", "trigger0", 1000.0, 128}, channels_, roots_), "");
  EXPECT_EQ(source.scan_bytes(), 16u);
  EXPECT_EQ(get("scan_elements/in_temp_en"), "0");
  EXPECT_EQ(get("scan_elements/in_voltage0_en"), "1");
  EXPECT_EQ(get("trigger/current_trigger"), "trigger0");
  EXPECT_EQ(get("sampling_frequency"), "1000");
  EXPECT_EQ(get("buffer/length"), "128");
  EXPECT_EQ(get("buffer/enable"), "1");

  firmware::RawSample sample;
  EXPECT_EQ(source.read(sample), SampleResult::kNone);
  deliver(-2, 300, 5000000);
  ASSERT_EQ(source.read(sample), SampleResult::kSample);
  EXPECT_EQ(sample.code[2][1], -2);
  EXPECT_EQ(sample.code[0][0], 300);
  EXPECT_EQ(sample.code[0][1], 0);
  EXPECT_EQ(sample.time_ns, 5000000u);
  EXPECT_EQ(source.read(sample), SampleResult::kNone);
}

// The last element stands from before, and the first does not go on: by then the last one is off.
TEST_F(IioDevice, WhatIsNotWantedIsOffBeforeAnythingIsSwitchedOn) {
  add_buffer();
  const std::string first = roots_.devices + "/iio:device1/scan_elements/in_voltage0_en";
  std::filesystem::remove(first);
  std::filesystem::create_directory(first);  // takes no text
  hal::IioBufferSource source(clock_);
  EXPECT_NE(source.open({"adc16", "", 1000.0, 128}, channels_, roots_).find("in_voltage0 cannot be switched on"),
            std::string::npos);
  EXPECT_EQ(get("scan_elements/in_temp_en"), "0");
}

// A timer trigger (hrtimer) has the rate, not the converter.
TEST_F(IioDevice, TheTriggersRateIsSet) {
  add_buffer();
  std::filesystem::remove(roots_.devices + "/iio:device1/sampling_frequency");
  put("trigger3/name", "timer500");
  put("trigger3/sampling_frequency", "100");
  hal::IioBufferSource source(clock_);
  ASSERT_EQ(source.open({"adc16", "timer500", 500.0, 128}, channels_, roots_), "");
  EXPECT_EQ(hal::read_text(roots_.devices + "/trigger3/sampling_frequency"), "500");
  EXPECT_EQ(get("trigger/current_trigger"), "timer500");
}

// What it is told is not what it does: 12.5 Hz is written with its point, and what stands there then has to be it.
TEST(IioRate, IsWrittenAndReadBack) {
  EXPECT_EQ(hal::rate_text(1000.0), "1000");
  EXPECT_EQ(hal::rate_text(12.5), "12.5");
  EXPECT_EQ(hal::rate_text(1000.0 / 3.0), "333.333333");
  EXPECT_TRUE(hal::is_rate("333.333", 1000.0 / 3.0));
  EXPECT_TRUE(hal::is_rate("12.500000", 12.5));
  EXPECT_FALSE(hal::is_rate("13", 12.5));
  EXPECT_FALSE(hal::is_rate("1000", 1000.2));  // 2e-4
  EXPECT_TRUE(hal::is_rate("", 12.5));         // tells nothing
}

TEST_F(IioDevice, AHoleInTheStampsIsAHoleInTheSequence) {
  add_buffer();
  hal::IioBufferSource source(clock_);
  ASSERT_EQ(source.open({"adc16", "", 1000.0, 128}, channels_, roots_), "");
  firmware::RawSample sample;
  // 1 ms apart, with 40 us of jitter, then three samples lost: 4 ms.
  const struct {
    uint64_t stamp_ns;
    uint32_t sequence;
  } scans[] = {{1000000, 0}, {2040000, 1}, {2990000, 2}, {6990000, 6}, {8000000, 7}};
  for (const auto& scan : scans) {
    deliver(1, 1, scan.stamp_ns);
    ASSERT_EQ(source.read(sample), SampleResult::kSample);
    EXPECT_EQ(sample.sequence, scan.sequence);
  }
}

// At 20 kHz one stamp is 30 us late, more than half a period, and none is lost. Then one is lost, with its stamp 10 us late, and
// one more behind it: seen at once. The first stamp is 30 us late as well.
TEST_F(IioDevice, ALateStampIsNoMissedSample) {
  add_buffer();
  hal::IioBufferSource source(clock_);
  ASSERT_EQ(source.open({"adc16", "", 20000.0, 128}, channels_, roots_), "");
  firmware::RawSample sample;
  const struct {
    uint64_t stamp_us;
    uint32_t sequence;
  } scans[] = {{1030, 0}, {1050, 1}, {1100, 2}, {1180, 3}, {1200, 4}, {1250, 5}, {1300 + 50 + 10, 7}, {1450, 9}};
  for (const auto& scan : scans) {
    deliver(1, 1, scan.stamp_us * 1000);
    ASSERT_EQ(source.read(sample), SampleResult::kSample);
    EXPECT_EQ(sample.sequence, scan.sequence) << scan.stamp_us;
  }
}

// A clock that is 2000 ppm slow or fast: after 5000 samples it is ten periods off, and still each one is the next, also where one
// is 30 us late. A lost one is seen at once.
TEST_F(IioDevice, AWrongRateDoesNotAddUp) {
  add_buffer();
  for (const double period_ns : {50100.0, 49900.0}) {
    hal::IioBufferSource source(clock_);
    ASSERT_EQ(source.open({"adc16", "", 20000.0, 128}, channels_, roots_), "");
    firmware::RawSample sample;
    const auto take = [&](int n, uint64_t late_ns) {
      deliver(1, 1, 1000000 + static_cast<uint64_t>(n * period_ns) + late_ns);
      ASSERT_EQ(source.read(sample), SampleResult::kSample);
    };
    for (int n = 0; n < 5000; ++n) {
      take(n, n % 100 == 99 ? 30000 : 0);
      ASSERT_EQ(sample.sequence, static_cast<uint32_t>(n)) << period_ns;
    }
    take(5001, 0);
    EXPECT_EQ(sample.sequence, 5001u) << period_ns;
  }
}

// A buffer of 8 scans at 1 kHz. Read in time, a hole is the converter's. Read 8 ms late, the scans up to the eighth are
// there and those that came before the first read are not: dropped for want of room.
TEST_F(IioDevice, AHoleBehindAFullBufferIsAnOverflow) {
  add_buffer();
  hal::IioBufferSource source(clock_);
  ASSERT_EQ(source.open({"adc16", "", 1000.0, 8}, channels_, roots_), "");
  firmware::RawSample sample;
  const auto take = [&](uint64_t stamp_ms, uint64_t now_ms) {
    clock_.time_ns = now_ms * 1000000;
    deliver(1, 1, stamp_ms * 1000000);
    ASSERT_EQ(source.read(sample), SampleResult::kSample);
  };
  take(100, 100);
  take(103, 103);  // two missing: the buffer was empty
  EXPECT_EQ(source.overflows(), 0u);
  for (uint64_t i = 0; i < 8; ++i) take(104 + i, 115);  // nobody read from 104 to 115
  EXPECT_EQ(source.overflows(), 0u);
  take(116, 116);  // 112 to 115 found no room
  EXPECT_EQ(source.overflows(), 4u);
  EXPECT_EQ(sample.sequence, 16u);  // and are missing in the sequence as well
  take(119, 119);
  EXPECT_EQ(source.overflows(), 4u);
}

TEST_F(IioDevice, StampsOfTheTimeOfDayAreMovedToTheMonotonicClock) {
  add_buffer();
  std::filesystem::remove(roots_.devices + "/iio:device1/current_timestamp_clock");  // a kernel that has none
  hal::IioBufferSource source(clock_);
  ASSERT_EQ(source.open({"adc16", "", 1000.0, 8}, channels_, roots_), "");
  firmware::RawSample sample;
  const uint64_t before_ns = hal::read_clock_ns(CLOCK_MONOTONIC);
  deliver(1, 1, hal::read_clock_ns(CLOCK_REALTIME));
  ASSERT_EQ(source.read(sample), SampleResult::kSample);
  EXPECT_GE(sample.time_ns + 1000000, before_ns);  // the two clocks are read one after the other
  EXPECT_LE(sample.time_ns, hal::read_clock_ns(CLOCK_MONOTONIC));
}

// The network sets the clock an hour ahead while a sample waits: it is no hour old.
TEST(MonotonicClock, AStampFromBeforeTheClockWasSetIsNow) {
  const uint64_t day_ns = hal::read_clock_ns(CLOCK_REALTIME), now_ns = hal::read_clock_ns(CLOCK_MONOTONIC);
  EXPECT_GE(hal::monotonic_from_time_of_day_ns(day_ns - 3600000000000), now_ns);
  EXPECT_GE(hal::monotonic_from_time_of_day_ns(day_ns + 3600000000000), now_ns);
  const uint64_t waited = hal::monotonic_from_time_of_day_ns(day_ns - 500000000);  // half a second in a buffer
  EXPECT_LT(waited, now_ns);
  EXPECT_GT(waited + 1000000000, now_ns);
}

TEST_F(IioDevice, TheDriverTellsWhereAConverterSaturates) {
  add_buffer();
  put("iio:device1/scan_elements/in_voltage0_type", "be:u12/16>>0");
  hal::IioBufferSource source(clock_);
  ASSERT_EQ(source.open({"adc16", "", 1000.0, 8}, channels_, roots_), "");
  EXPECT_EQ(source.range(2, Quantity::kDisplacement).lowest, 0);
  EXPECT_EQ(source.range(2, Quantity::kDisplacement).highest, 4095);
  EXPECT_EQ(source.range(0, Quantity::kForce).lowest, -32768);
  EXPECT_EQ(source.range(0, Quantity::kForce).highest, 32767);
}

TEST_F(IioDevice, HalfAScanWaitsForItsOtherHalf) {
  add_buffer();
  hal::IioBufferSource source(clock_);
  ASSERT_EQ(source.open({"adc16", "", 1000.0, 128}, channels_, roots_), "");
  firmware::RawSample sample;
  const uint8_t scan[16] = {0, 7, 0, 9};
  ASSERT_EQ(::write(pipe_.get(), scan, 5), 5);
  EXPECT_EQ(source.read(sample), SampleResult::kNone);
  ASSERT_EQ(::write(pipe_.get(), scan + 5, 11), 11);
  ASSERT_EQ(source.read(sample), SampleResult::kSample);
  EXPECT_EQ(sample.code[2][1], 7);
  EXPECT_EQ(sample.code[0][0], 9);
}

TEST_F(IioDevice, SaysWhatIsWrong) {
  hal::IioBufferSource none(clock_), direct_only(clock_), element(clock_);
  EXPECT_NE(none.open({"adc17", "", 1000.0, 128}, channels_, roots_).find("\"adc17\" was not found"),
            std::string::npos);
  EXPECT_NE(direct_only.open({"adc16", "", 1000.0, 128}, channels_, roots_).find("iio_direct"), std::string::npos);
  add_buffer();
  const std::string fault = element.open({"adc16", "", 1000.0, 128}, {{"in_voltage9", 0, Quantity::kForce}}, roots_);
  EXPECT_NE(fault.find("in_voltage9"), std::string::npos) << fault;
  EXPECT_NE(fault.find("in_voltage0, in_voltage1, in_temp"), std::string::npos) << fault;
}

}  // namespace

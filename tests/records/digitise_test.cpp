// Records as converter codes: units, rounding, saturation, and the replaying sample source.
#include "host_sim/records/digitise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/records/csv/csv_reader.hpp"

namespace {

rig_file::RigModel rig(const std::string& channel = "") {
  return rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1\n[[link]]\nbetween = [1, 0]\nviscous_N_s_m = \"estimate\"\n" + channel,
      "r.toml");
}

TEST(Digitise, UnitIsThePowerOfTwoThatFillsTwentyThreeBits) {
  // Largest 3 N lies in [2, 4): unit 2^2 / 2^23 = 2^-21, so 3 N is code 3 * 2^21.
  const auto record = host_sim::parse_csv("t_s,force_1_N,velocity_1_m_s\n0,-3,0\n1,1,0\n", "d.csv", rig());
  const auto calibrations = host_sim::calibrate({record}, rig());
  ASSERT_EQ(calibrations.size(), 2u);
  EXPECT_EQ(calibrations[0].unit_per_code, 0x1p-21);
  EXPECT_EQ(host_sim::to_code(-3.0, calibrations[0]), -3 * (1 << 21));
  EXPECT_EQ(host_sim::to_code(0.0, calibrations[1]), 0);  // a silent channel
  EXPECT_EQ(calibrations[1].unit_per_code, 0x1p-23);      // 1 m/s at full scale
}

TEST(Digitise, RoundingMovesNoValueByMoreThanTwoToMinus23OfTheLargest) {
  for (const double largest : {1.0, 1.999, 4194303.6, 1e-9, 3.7e8, 0.99999999}) {
    host_sim::Record record;
    record.channels.push_back({"force_1_N", host_sim::Quantity::kForce, 1, {largest}});
    for (int i = 0; i < 1000; ++i) record.channels[0].values.push_back(largest * std::sin(i));
    const auto calibration = host_sim::calibrate({record}, rig()).at(0);
    for (const double value : record.channels[0].values) {
      const int32_t code = host_sim::to_code(value, calibration);
      EXPECT_LT(std::abs(code), calibration.highest_code) << largest;
      EXPECT_LE(std::abs(code * calibration.unit_per_code - value), largest * 0x1p-23) << largest;
    }
  }
}

TEST(Digitise, HalvesGoToTheEvenCodeAndWhatIsFarBeyondToTheRail) {
  rig_file::ChannelCalibration calibration;
  calibration.unit_per_code = 1.0;
  calibration.lowest_code = -8388607, calibration.highest_code = 8388607;
  for (const double value : {0.5, 1.5, 2.5, -0.5, -1.5, 0.49999999999999994, 8388606.5, 1234567.5, -7.25})
    EXPECT_EQ(host_sim::to_code(value, calibration), static_cast<int32_t>(std::nearbyint(value))) << value;
  for (const double value : {1e8, 0x1p51, 0x1.8p52, 1e20, 1e308}) {
    EXPECT_EQ(host_sim::to_code(value, calibration), 8388607) << value;
    EXPECT_EQ(host_sim::to_code(-value, calibration), -8388607) << value;
  }
}

TEST(Digitise, AllRecordsShareOneUnit) {
  const auto small = host_sim::parse_csv("t_s,force_1_N\n0,1\n1,1\n", "d.csv", rig());
  const auto large = host_sim::parse_csv("t_s,force_1_N\n0,100\n1,1\n", "e.csv", rig());
  EXPECT_EQ(host_sim::calibrate({small, large}, rig())[0].unit_per_code, 0x1p-16);  // 100 lies in [64, 128)
}

TEST(Digitise, ConvertersWithUnequalRailsSaturateAtEach) {
  const auto model =
      rig("[[channel]]\nname = \"force_1_N\"\nunit_per_code = 0.5\noffset_code = 2048\nlowest_code = 0\n"
          "highest_code = 4095\n");
  const auto record = host_sim::parse_csv("t_s,force_1_N\n0,3\n1,1000\n", "d.csv", model);
  const auto calibration = host_sim::calibrate({record}, model).at(0);
  EXPECT_EQ(host_sim::to_code(3.0, calibration), 2054);  // 3 / 0.5 + 2048
  EXPECT_EQ(host_sim::to_code(-2000.0, calibration), 0);
  EXPECT_EQ(host_sim::to_code(2000.0, calibration), 4095);
}

// 1000 N are 2000 codes of 0.5 N, below 2^11: rails at 2^12 on either side of the offset. In a range of the core's 24 bits they would have
// no cube.
TEST(Digitise, RailsThatAreLeftOutLieBeyondWhatWasRecorded) {
  const std::string channel = "[[channel]]\nname = \"force_1_N\"\nunit_per_code = 0.5\noffset_code = 10\n";
  const auto record = host_sim::parse_csv("t_s,force_1_N\n0,3\n1,1000\n", "d.csv", rig(channel));
  const auto calibration = host_sim::calibrate({record}, rig(channel)).at(0);
  EXPECT_EQ(calibration.lowest_code, 10 - 4096);
  EXPECT_EQ(calibration.highest_code, 10 + 4096);
  EXPECT_EQ(host_sim::calibrate({record}, rig(channel + "full_scale_code = 32767\n")).at(0).highest_code, 32767);
}

TEST(Digitise, CalibrationOfTheRigFileIsUsedAndSaturates) {
  const auto model =
      rig("[[channel]]\nname = \"force_1_N\"\nunit_per_code = 0.5\noffset_code = 10\nfull_scale_code = 100\ndelay_us = "
          "250\n");
  const auto record = host_sim::parse_csv("t_s,force_1_N\n0,3\n1,1000\n", "d.csv", model);
  const auto calibration = host_sim::calibrate({record}, model).at(0);
  EXPECT_EQ(host_sim::to_code(3.0, calibration), 16);      // 3 / 0.5 + 10
  EXPECT_EQ(host_sim::to_code(1000.0, calibration), 100);  // stuck at full scale
  EXPECT_EQ(host_sim::to_code(-1000.0, calibration), -100);
  EXPECT_DOUBLE_EQ(calibration.delay_s, 250e-6);
}

TEST(RecordSampleSource, ReplaysEverySampleOnceAtItsNode) {
  const auto record = host_sim::parse_csv("t_s,force_1_N,velocity_1_m_s\n0,1,0.5\n0.25,0.5,-1\n", "d.csv", rig());
  const auto calibrations = host_sim::calibrate({record}, rig());  // largest 1 lies in [1, 2): unit 2^-22
  host_sim::RecordSampleSource source(record, calibrations);
  firmware::RawSample sample;
  ASSERT_EQ(source.read(sample), hal::SampleResult::kSample);
  EXPECT_EQ(sample.code[0][0], 1 << 22);
  EXPECT_EQ(sample.code[0][2], 1 << 21);
  ASSERT_EQ(source.read(sample), hal::SampleResult::kSample);
  EXPECT_EQ(sample.sequence, 1u);
  EXPECT_EQ(sample.time_ns, 250000000u);
  EXPECT_EQ(sample.code[0][2], -(1 << 22));
  EXPECT_EQ(source.read(sample), hal::SampleResult::kEnd);
}

}  // namespace

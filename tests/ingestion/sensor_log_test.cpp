// Sensor logs: lines written by hand from the layout in docs/can_protocol.md.
#include <gtest/gtest.h>

#include "host_sim/ingestion/sensor_log_reader.hpp"
#include "tests/ingestion/rigs.hpp"

namespace {

using host_sim::parse_sensor_log;
using host_sim::Quantity;
using test_rigs::dampers;
using test_rigs::expect_says;
using test_rigs::refusal;

// 16-bit motion of DOF 1 (1A1) and its force (221), both little-endian: sequence; x, v, a; and sequence; force.
// Sample 5: x = 0x0102 = 258, v = -1, a = 3, force = 0x000010 = 16. Sample 6: x = -258, v = 1, a = -3, force = -16.
constexpr char kTwoSamples[] =
    "(1000000000.000000) vcan0 1A1#05000201FFFF0300\n"
    "(1000000000.000100) vcan0 221#0500100000\n"
    "(1000000000.001000) vcan0 1A1#0600FEFE0100FDFF\n"
    "(1000000000.001100) vcan0 221#0600F0FFFF\n";

const char kCalibration[] =
    "[[channel]]\nname = \"displacement_1_m\"\nunit_per_code = 0.5\noffset_code = 8\n"
    "[[channel]]\nname = \"force_1_N\"\nunit_per_code = 2.0\n";

TEST(SensorLog, TheRigFilesCalibrationMakesUnitsOfCodes) {
  const auto record = parse_sensor_log(kTwoSamples, "s.log", dampers(1, 0, kCalibration));
  ASSERT_EQ(record.channels.size(), 2u);
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{125.0, -133.0}));  // (258 - 8) / 2
  EXPECT_EQ(record.find(Quantity::kForce, 1)->values, (std::vector<double>{32.0, -32.0}));
  EXPECT_NEAR(record.sample_period_s, 1e-3, 1e-12);
  EXPECT_EQ(record.start_s, 0.0);
}

// scaling (691, node 1): place 1, quantity 2 (velocity) in bits 5 and 6 -> 0x41; exponent -3 -> FD; 25 -> 19000000; no
// delay. range (6A1): the same place, offset 1, full scale 0x7FFF. So v = (code - 1) * 0.025.
TEST(SensorLog, TheLogsOwnDescriptionIsTakenWhereTheRigFileHasNone) {
  const std::string description =
      "(1000000000.000000) vcan0 691#41FD190000000000\n"
      "(1000000000.000000) vcan0 6A1#41010000FF7F00\n";
  const auto record = parse_sensor_log(kTwoSamples + description, "s.log", dampers(1));
  ASSERT_EQ(record.channels.size(), 1u);
  EXPECT_EQ(record.channels[0].name, "velocity_1_m_s");
  EXPECT_NEAR(record.channels[0].values[0], -0.05, 1e-15);  // (-1 - 1) * 0.025
  EXPECT_NEAR(record.channels[0].values[1], 0.0, 1e-15);
}

TEST(SensorLog, OtherFramesAndLinesArePassedOver) {
  const std::string others =
      "# a comment\n(1000000000.000050) vcan0 7FF#00\n(1000000000.000050) vcan0 20000004#0000000000000000\n";
  EXPECT_EQ(parse_sensor_log(others + kTwoSamples + others, "s.log", dampers(1, 0, kCalibration)).samples(), 2u);
}

TEST(SensorLog, ALogThatEndsWithinASampleKeepsTheWholeOnes) {
  const std::string text = std::string(kTwoSamples) + "(1000000000.002000) vcan0 1A1#0700000000000000\n";
  EXPECT_EQ(parse_sensor_log(text, "s.log", dampers(1, 0, kCalibration)).samples(), 2u);
}

// After sample 65535 comes 0: the sequence has 16 bits.
TEST(SensorLog, TheSequenceCountsOnAfterItsLastNumber) {
  const std::string text =
      "(1000000000.000000) vcan0 1A1#FFFF000000000000\n(1000000000.000000) vcan0 221#FFFF000000\n"
      "(1000000000.001000) vcan0 1A1#0000000000000000\n(1000000000.001000) vcan0 221#0000000000\n";
  EXPECT_EQ(parse_sensor_log(text, "s.log", dampers(1, 0, kCalibration)).samples(), 2u);
}

TEST(SensorLog, RefusesGapsAndMissingCalibrations) {
  const auto rig = dampers(1, 0, kCalibration);
  const std::string gap = std::string(kTwoSamples) +
                          "(1000000000.003000) vcan0 1A1#0800000000000000\n(1000000000.003000) vcan0 221#0800000000\n";
  expect_says(refusal([&] { parse_sensor_log(gap, "s.log", rig); }), "s.log:6: sample 8 follows sample 6, expected 7");
  expect_says(refusal([&] { parse_sensor_log(kTwoSamples, "s.log", dampers(1)); }), "codes without a calibration");
  const std::string motion_only =
      "(1000000000.000000) vcan0 1A1#0500020100000000\n(1000000000.001000) vcan0 1A1#0600020100000000\n";
  expect_says(refusal([&] { parse_sensor_log(motion_only, "s.log", rig); }),
              "carries no codes of force_1_N, which the rig file calibrates");
  expect_says(refusal([&] { parse_sensor_log("(1.0) vcan0 7FF#00\n", "s.log", rig); }), "no sensor frame");
  const std::string mixed = std::string(kTwoSamples) + "(1000000000.002000) vcan0 1C1#0700000000000000\n";
  expect_says(refusal([&] { parse_sensor_log(mixed, "s.log", rig); }), "s.log:5: frame sensor_motion_24");
}

TEST(SensorLog, IsRecognisedByNameOrFirstLine) {
  EXPECT_TRUE(host_sim::is_sensor_log("a.log", ""));
  EXPECT_TRUE(host_sim::is_sensor_log("a.txt", kTwoSamples));
  EXPECT_FALSE(host_sim::is_sensor_log("a.csv", "t_s,force_1_N\n0,1\n"));
}

}  // namespace

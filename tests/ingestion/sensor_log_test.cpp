// Sensor logs: lines written by hand from the layout in docs/can_protocol.md.
#include <gtest/gtest.h>

#include <functional>

#include "host_sim/can_log/asc_line.hpp"
#include "host_sim/ingestion/sensor_log/log_times.hpp"
#include "host_sim/ingestion/sensor_log/sensor_log_reader.hpp"
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

// The same two samples as other programs write them: candump with calendar dates (over midnight), with its screen's
// columns, and Vector's .asc in hexadecimal and in decimal, with absolute and with relative times.
TEST(SensorLog, OtherProgramsWriteTheSameSamples) {
  const std::string forms[] = {
      "(2026-02-28 23:59:59.999000) vcan0 1A1#05000201FFFF0300\n(2026-02-28 23:59:59.999100) vcan0 221#0500100000\n"
      "(2026-03-01 00:00:00.000000) vcan0 1A1#0600FEFE0100FDFF\n(2026-03-01 00:00:00.000100) vcan0 221#0600F0FFFF\n",
      " (2026-11-22 07:00:00.000000)  vcan0  1A1   [8]  05 00 02 01 FF FF 03 00\n"
      " (2026-11-22 07:00:00.000100)  vcan0  221   [5]  05 00 10 00 00\n"
      " (2026-11-22 07:00:00.001000)  vcan0  1A1   [8]  06 00 FE FE 01 00 FD FF\n"
      " (2026-11-22 07:00:00.001100)  vcan0  221   [5]  06 00 F0 FF FF\n",
      "date Sun Nov 22 07:00:00.000 am 2026\nbase hex  timestamps absolute\nno internal events logged\n"
      "Begin Triggerblock Sun Nov 22 07:00:00.000 am 2026\n   0.000000 Start of measurement\n"
      "   1.000000 1  1A1             Rx   d 8 05 00 02 01 FF FF 03 00  Length = 244000 BitCount = 125 ID = 417\n"
      "   1.000100 1  221             Rx   d 5 05 00 10 00 00\n   1.000500 1  Statistic: D 1 R 0\n"
      "   1.001000 1  1A1             Rx   d 8 06 00 fe fe 01 00 fd ff\n"
      "   1.001100 1  221             Rx   d 5 06 00 F0 FF FF\nEnd TriggerBlock\n",
      "date Sun Nov 22 07:00:00.000 am 2026\r\nbase dec  timestamps relative\r\n"
      "   1.000000 1  417             Rx   d 8 5 0 2 1 255 255 3 0\r\n   0.000100 1  545             Rx   d 5 5 0 16 0 "
      "0\r\n"
      "   0.000900 1  417             Rx   d 8 6 0 254 254 1 0 253 255\r\n"
      "   0.000100 1  545             Rx   d 5 6 0 240 255 255\r\n",
  };
  for (const std::string& form : forms) {
    SCOPED_TRACE(form.substr(0, 60));
    EXPECT_TRUE(host_sim::is_sensor_log("recording.txt", form));
    const auto record = parse_sensor_log(form, "s.log", dampers(1, 0, kCalibration));
    EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{125.0, -133.0}));
    EXPECT_EQ(record.find(Quantity::kForce, 1)->values, (std::vector<double>{32.0, -32.0}));
    EXPECT_NEAR(record.sample_period_s, 1e-3, 1e-12);
  }
}

// CAN FD of .asc: channel, direction, identifier, a name or none, bit rate switch, error state, length code, length.
TEST(SensorLog, VectorsCanFdLines) {
  for (const char* name : {"", "Samples "}) {
    can_log::AscLog log;
    can_log::LogEntry entry;
    const std::string line = std::string("   0.003000 CANFD   1 Rx        18FF0102x  ") + name +
                             "1 0 9 12 11 22 33 44 55 66 77 88 99 AA BB CC 130000 130 303000 e 0 0";
    ASSERT_TRUE(log.parse(line, entry)) << line;
    EXPECT_TRUE(entry.frame.fd);
    EXPECT_TRUE(entry.frame.extended);
    EXPECT_EQ(entry.frame.id, 0x18FF0102u);
    EXPECT_EQ(entry.frame.flags, 1);
    ASSERT_EQ(entry.frame.length, 12);
    EXPECT_EQ(entry.frame.data[11], 0xCC);
    EXPECT_EQ(entry.frame.time_ns, 3000000u);
  }
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

// Samples 5, 6 and 8, a millisecond apart: 7 is lost. Times are those of the numbers, not of the frames' arrival.
TEST(SensorLog, ALostSampleLeavesItsTimeWhereTheRecordIsInterpolated) {
  const std::string gap = std::string(kTwoSamples) +
                          "(1000000000.003000) vcan0 1A1#0800000000000000\n(1000000000.003000) vcan0 221#0800000000\n";
  host_sim::ReadingOptions options;
  options.resample_Hz = 1000.0;
  const auto record = parse_sensor_log(gap, "s.log", dampers(1, 0, kCalibration), options);
  ASSERT_EQ(record.time_s.size(), 3u);
  EXPECT_EQ(record.time_s[0], 0.0);
  EXPECT_NEAR(record.time_s[1], 1e-3, 1e-12);
  EXPECT_NEAR(record.time_s[2], 3e-3, 1e-12);
  EXPECT_NEAR(record.sample_period_s, 1e-3, 1e-12);
  EXPECT_EQ(record.notes, (std::vector<std::string>{"1 sample was lost on the bus"}));
}

// 20 samples at 1 kHz, then a pause of `pause` of them in which the 16-bit sequence goes on, and 20 more.
std::string paused(uint32_t pause) {
  std::string text;
  char line[128];
  for (uint32_t i = 0; i < 40; ++i) {
    const uint32_t n = i + (i < 20 ? 0 : pause), ms = n, low = n & 0xFF, high = (n >> 8) & 0xFF;
    std::snprintf(line, sizeof line,
                  "(%u.%03u000) vcan0 1A1#%02X%02X020100000000\n(%u.%03u100) vcan0 221#%02X%02X100000\n",
                  1000000000 + ms / 1000, ms % 1000, low, high, 1000000000 + ms / 1000, ms % 1000, low, high);
    text += line;
  }
  return text;
}

// Half a round of the sequence is 32,768 samples; one of 65,536 brings it back to where it was. The time tells which it is.
TEST(SensorLog, APauseInWhichTheSequenceGoesRound) {
  host_sim::ReadingOptions options;
  options.resample_Hz = 1000.0;
  for (const uint32_t pause : {30000u, 40000u, 65536u, 70000u, 200000u}) {
    const auto record = parse_sensor_log(paused(pause), "s.log", dampers(1, 0, kCalibration), options);
    ASSERT_EQ(record.samples(), 40u) << pause;
    EXPECT_NEAR(record.sample_period_s, 1e-3, 1e-9) << pause;
    EXPECT_NEAR(record.time_s.back(), 1e-3 * (39 + pause), 1e-6) << pause;
    EXPECT_EQ(record.notes.back(), std::to_string(pause) + " samples were lost on the bus");
  }
  expect_says(refusal([] { parse_sensor_log(paused(65536), "s.log", dampers(1, 0, kCalibration)); }), "--resample");
}

// 40 samples: the first frame's time is what `time` prints of it, that of the second 200 microseconds, or nothing.
std::string forty(const std::function<std::string(int)>& time, const std::string& second) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    char line[128];
    std::snprintf(line, sizeof line,
                  "%s  vcan0  1A1   [8]  %02X 00 02 01 00 00 00 00\n%s  vcan0  221   [5]  %02X 00 10 00 00\n",
                  time(i).c_str(), i, second.c_str(), i);
    text += line;
  }
  return text;
}

void expect_only_by_rate(const std::string& text, const std::string& said) {
  const auto rig = dampers(1, 0, kCalibration);
  expect_says(refusal([&] { parse_sensor_log(text, "s.log", rig); }), said);
  expect_says(refusal([&] { parse_sensor_log(text, "s.log", rig); }), "candump -L or candump -t a");
  host_sim::ReadingOptions options;
  options.sample_rate_Hz = 800;
  const auto record = parse_sensor_log(text, "s.log", rig, options);
  EXPECT_EQ(record.samples(), 40u);
  EXPECT_EQ(record.sample_period_s, 1.0 / 800);
}

// candump -t d: how long after the frame before; of one frame after the other without pause it is one and the same.
TEST(SensorLog, DifferencesOfTimesAreRefused) {
  const auto wavering = [](int i) { return "(000.000" + std::to_string(770 + 3 * (i % 5)) + ")"; };
  expect_only_by_rate(forty(wavering, "(000.000200)"), "candump -t d");
  const auto steady = [](int i) { return i == 0 ? "(000.000000)" : "(000.000120)"; };
  expect_only_by_rate(forty(steady, "(000.000120)"), "candump -t d");
}

// candump without options.
TEST(SensorLog, ALogWithoutTimesNeedsTheRate) {
  expect_only_by_rate(forty([](int) { return ""; }, ""), "the log has no times");
}

// A clock that is set back once, and one of 10 ms at a sample a millisecond, are clocks.
TEST(SensorLog, AClockIsNotTakenForDifferences) {
  const auto clock = [](double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "(%.6f)", seconds);
    return std::string(text);
  };
  const auto times = [&](const std::function<double(int)>& of) {
    host_sim::LogTimes times;
    for (int i = 0; i < 400; ++i) {
      can_log::LogEntry entry;
      EXPECT_TRUE(can_log::parse_line(clock(of(i)) + " can0 1A1#00", entry));
      times.learn(entry);
    }
    return times;
  };
  EXPECT_TRUE(times([](int i) { return 5000 + 1e-3 * i - (i > 20 ? 3600 : 0); }).tell());
  EXPECT_TRUE(times([](int i) { return 0.01 * (i / 40); }).tell());
  EXPECT_TRUE(times([](int i) { return i == 0 ? 0 : 1e-4; }).differences());
}

// A channel can be left out, and the rate of the board be told; a unit is what the calibration gives.
TEST(SensorLog, TakesWhatTheUserSaysOfAChannel) {
  const auto rig = dampers(1, 0, kCalibration);
  host_sim::ReadingOptions options;
  options.columns = {{"force_1", ""}};
  options.sample_rate_Hz = 800;
  const auto record = parse_sensor_log(kTwoSamples, "s.log", rig, options);
  ASSERT_EQ(record.channels.size(), 1u);
  EXPECT_EQ(record.channels[0].name, "displacement_1_m");
  EXPECT_EQ(record.sample_period_s, 1.0 / 800);
  options.columns.push_back({"displacement_1", ""});
  expect_says(refusal([&] { parse_sensor_log(kTwoSamples, "s.log", rig, options); }), "no channel is left");
  host_sim::ReadingOptions units;
  units.units = {{"displacement_1", "mm"}};
  expect_says(refusal([&] { parse_sensor_log(kTwoSamples, "s.log", rig, units); }),
              "--unit displacement_1=\"mm\": the calibration of a CAN log gives SI units, expected unit_per_code");
}

// 25 thousandths, then 24; behind it a description as before would do.
TEST(SensorLog, ACalibrationThatChangesWithinTheLogIsRefused) {
  const std::string scaling = "(1000000000.000000) vcan0 691#41FD190000000000\n",
                    other = "(1000000000.000500) vcan0 691#41FD180000000000\n",
                    range = "(1000000000.000000) vcan0 6A1#41010000FF7F00\n",
                    other_range = "(1000000000.000000) vcan0 6A1#41020000FF7F00\n";
  EXPECT_EQ(parse_sensor_log(scaling + range + kTwoSamples + range + scaling, "s.log", dampers(1)).samples(), 2u);
  expect_says(refusal([&] { parse_sensor_log(scaling + kTwoSamples + other, "s.log", dampers(1)); }),
              "s.log:6: frame scaling of velocity_1_m_s says another value than before");
  expect_says(refusal([&] { parse_sensor_log(scaling + range + kTwoSamples + other_range, "s.log", dampers(1)); }),
              "s.log:7: frame range of velocity_1_m_s says another value than before");
}

TEST(SensorLog, RefusesGapsAndMissingCalibrations) {
  const auto rig = dampers(1, 0, kCalibration);
  const std::string gap = std::string(kTwoSamples) +
                          "(1000000000.003000) vcan0 1A1#0800000000000000\n(1000000000.003000) vcan0 221#0800000000\n";
  expect_says(refusal([&] { parse_sensor_log(gap, "s.log", rig); }), "s.log:6: sample 8 follows sample 6, expected 7");
  expect_says(refusal([&] { parse_sensor_log(gap, "s.log", rig); }), "--resample with the sampling rate interpolates");
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

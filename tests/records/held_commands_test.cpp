// Forces that are written at their changes, in rows of their own, beside a motion that is written all the time.
#include "host_sim/records/csv/blanks/held_commands.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/times/resample.hpp"

namespace {

using host_sim::Record;

// 10 s of a motion at 100 a second; 2 ms behind its row of 0.5 s and every `step_ms` from there on the k-th value of the force.
std::string by_turns(int step_ms, const std::function<double(int)>& force) {
  std::string text = "t_s,force_1_N,displacement_1_m\n";
  for (int ms = 0, k = 0; ms < 10000; ms += 10) {
    text += fmt::format("{:.3f},,{:.9f}\n", 1e-3 * ms, std::sin(3e-3 * ms));
    if (ms >= 500 && (ms - 500) % step_ms == 0) text += fmt::format("{:.3f},{:.9f},\n", 1e-3 * (ms + 2), force(k++));
  }
  return text;
}

Record read(const std::string& text, double rate_Hz) {
  host_sim::ReadingOptions options;
  options.resample_Hz = rate_Hz;
  return host_sim::resampled(host_sim::parse_csv(text, "d.csv", {}, options), rate_Hz).at(0);
}

bool notes_hold(const Record& record) {
  for (const std::string& note : record.notes)
    if (note.find("a command that is written now and then, held from each value to the next") != std::string::npos)
      return true;
  return false;
}

// 0.502 s: 1 N; 2.502 s: -2 N; 4.502: 1 N; 6.502: -2 N; 8.502 s: 1 N, to the end. The row of 0.50 s lacks the force and goes.
TEST(HeldCommands, ACommandStaysFromOneChangeToTheNext) {
  const Record record = read(by_turns(2000, [](int k) { return k % 2 == 0 ? 1.0 : -2.0; }), 100.0);
  EXPECT_TRUE(notes_hold(record));
  const std::vector<double>& force = record.channels[0].values;
  EXPECT_NEAR(record.start_s, 0.51, 0.01);
  EXPECT_NEAR(record.start_s + 0.01 * static_cast<double>(force.size()), 10.0, 0.02);
  for (size_t i = 0; i < force.size(); ++i) {
    const double t = record.start_s + 0.01 * static_cast<double>(i), since = std::fmod(t - 0.502, 4.0);
    if (std::abs(since) < 0.011 || std::abs(since - 2) < 0.011 || since > 3.989)
      continue;  // a sample, where it changes
    EXPECT_EQ(force[i], since < 2.0 ? 1.0 : -2.0) << t;
  }
}

// The cubic's four weights add up to 1 but for their rounding.
TEST(HeldCommands, AConstantStaysTheSameToTheLastBit) {
  for (const int step_ms : {30, 1000}) {  // filled between its values, and held
    const std::vector<double> force = read(by_turns(step_ms, [](int) { return 4.7; }), 100.0).channels[0].values;
    ASSERT_GT(force.size(), 900u);
    for (const double value : force) EXPECT_EQ(value, 4.7);
  }
}

// A load cell at 5 a second of a load of 0.25 Hz, 20 samples a period: 20 times rarer than the motion, and smooth. The cubic through
// two values on both sides misses 9/384 (w h)^4 = 0.0002 of the height; a hold would miss up to w h = 0.31.
TEST(HeldCommands, ASlowMeasurementIsInterpolated) {
  const auto load = [](double t) { return std::sin(2 * M_PI * 0.25 * t); };
  const Record record = read(by_turns(200, [&](int k) { return load(0.502 + 0.2 * k); }), 100.0);
  EXPECT_FALSE(notes_hold(record));
  for (size_t i = 30; i + 30 < record.samples(); ++i)
    EXPECT_NEAR(record.channels[0].values[i], load(record.start_s + 0.01 * static_cast<double>(i)), 0.001) << i;
}

// A stair of even steps is smooth, but no measurement at one in 200 of the motion's rows.
TEST(HeldCommands, AStairOfEvenStepsIsNoRamp) {
  const Record record = read(by_turns(2000, [](int k) { return 0.5 * k; }), 100.0);
  EXPECT_TRUE(notes_hold(record));
  for (const double value : record.channels[0].values) EXPECT_EQ(2 * value, std::floor(2 * value));
}

// Each of the two 50 times a second, by turns: 100 rows a second, and each channel's own rate is what must not be undercut.
TEST(HeldCommands, TheRateIsThatOfTheChannelsNotOfTheRows) {
  std::string text = "t_s,force_1_N,displacement_1_m\n";
  for (int i = 0; i < 400; ++i)
    text += fmt::format(i % 2 ? "{:.2f},,{:.6f}\n" : "{:.2f},{:.6f},\n", 0.01 * i, std::sin(0.03 * i));
  EXPECT_NEAR(static_cast<double>(read(text, 50.0).samples()), 200.0, 2.0);
  try {
    read(text, 40.0);
    ADD_FAILURE() << "taken";
  } catch (const host_sim::DataFileError& error) {
    EXPECT_NE(error.problem.find("has 50 samples a second; at 40 "), std::string::npos) << error.problem;
    EXPECT_NE(error.problem.find("--resample 50"), std::string::npos) << error.problem;
  }
}

}  // namespace

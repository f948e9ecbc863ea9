// Times as they are written: of clocks, rounded, in ticks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "tests/records/two_dofs.hpp"

namespace {

using host_sim::Quantity;
using host_sim::ReadingOptions;
using two_dofs::rig;

TEST(Dialects, ATimeThatIsNoClocksIsRefused) {
  for (const char* bad :
       {"25:00:00", "10:61:00", "2026-13-01T10:00:00", "10:11", "10:11:12 noon", "13:11:12 PM", "0:11:12 AM"})
    EXPECT_THROW(
        host_sim::parse_csv(std::string("t_s,force_1_N,displacement_1_m\n") + bad + ",1,2\n0.5,1,2\n", "d.csv", rig()),
        host_sim::DataFileError)
        << bad;
}

// Four rows half a second apart over midnight. Which of two numbers is the month, all dates together tell: one above twelve,
// else that the days follow one another.
TEST(Dialects, TheOrderOfDayAndMonthIsThatOfTheWholeColumn) {
  for (const auto& [before, behind] : {std::pair("03/04/2026", "03/05/2026"), std::pair("05/12/2026", "05/13/2026"),
                                       std::pair("04/03/2026", "05/03/2026"), std::pair("12.05.2026", "13.05.2026"),
                                       std::pair("12-31-2026", "01-01-2027"), std::pair("31/12/2026", "01/01/2027"),
                                       std::pair("12/12/2026", "13/12/2026")}) {
    const std::string text = fmt::format(
        "Time,force_1_N\n{0} 23:59:59.0,1\n{0} 23:59:59.5,2\n{1} 00:00:00.0,3\n{1} 00:00:00.5,4\n", before, behind);
    const auto record = host_sim::parse_csv(text, "d.csv", rig());
    EXPECT_NEAR(record.sample_period_s, 0.5, 1e-9) << before;
  }
}

TEST(Dialects, SampleRateStandsForTheTime) {
  ReadingOptions options;
  options.sample_rate_Hz = 250.0;
  const auto without = host_sim::parse_csv("force_1_N\n1\n2\n", "d.csv", rig(), options);
  EXPECT_EQ(without.sample_period_s, 0.004);
  const auto clock = host_sim::parse_csv("Time;force_1_N\n12:00:00,10;1\n12:00:00,14;2\n", "d.csv", rig(), options);
  EXPECT_EQ(clock.find(Quantity::kForce, 1)->values, (std::vector<double>{1, 2}));
}

// 1024 Hz in milliseconds: 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 21, 22, ...
std::string rounded_times(double rate_Hz, const char* format, size_t count, size_t lost = 0) {
  std::string text = "t_s,force_1_N\n";
  for (size_t i = 0; i < count; ++i) {
    if (lost > 0 && i == lost) continue;
    char row[60];
    std::snprintf(row, sizeof row, format, static_cast<double>(i) / rate_Hz);
    text += std::string(row) + ",1\n";
  }
  return text;
}

TEST(Dialects, RoundedTimesAreEven) {
  const auto record = host_sim::parse_csv(rounded_times(1024.0, "%.3f", 5000), "d.csv", rig());
  EXPECT_NEAR(record.sample_period_s, 1.0 / 1024.0, 1e-9);
  ASSERT_EQ(record.notes.size(), 1u);
  EXPECT_NE(record.notes[0].find("times are rounded to 0.001 s"), std::string::npos);
  const auto coarse = host_sim::parse_csv(rounded_times(2048.0, "%.3f", 5000), "d.csv", rig());
  EXPECT_NEAR(coarse.sample_period_s, 1.0 / 2048.0, 1e-9);
}

// Seven significant digits at 2048 Hz: 9.999512 is followed by 10.00000 and 10.00049, steps of 0.00048 and 0.00049; single
// precision at 10 kHz: from 64 s on its numbers lie 7.6 us apart.
TEST(Dialects, TimesOfSoManyDigitsAreEven) {
  const auto digits = host_sim::parse_csv(rounded_times(2048.0, "%.7g", 50000), "d.csv", rig());
  EXPECT_NEAR(digits.sample_period_s, 1.0 / 2048.0, 1e-9);
  EXPECT_THROW(host_sim::parse_csv(rounded_times(2048.0, "%.7g", 50000, 40000), "d.csv", rig()),
               host_sim::DataFileError);
  std::string text = "t_s,force_1_N\n";
  for (int i = 0; i < 50000; ++i)
    text += fmt::format("{:.17g},1\n", static_cast<double>(static_cast<float>(64.0 + 1e-4 * i)));
  EXPECT_NEAR(host_sim::parse_csv(text, "d.csv", rig()).sample_period_s, 1e-4, 1e-9);
}

// Five significant digits up to a second and four decimals from there on, at 3000 Hz: 9.9997 s is followed by 10.0000, not
// by 10.000, and 0.0003333 s stands where 0.0003 would.
TEST(Dialects, TimesWhoseDigitsChangeAtASecondAreEven) {
  const auto written = [](size_t lost) {
    std::string text = "t_s,force_1_N\n";
    for (size_t i = 0; i < 40000; ++i) {
      const double t = static_cast<double>(i) / 3000.0;
      if (lost == 0 || i != lost) text += t < 1.0 ? fmt::format("{:.5g},1\n", t) : fmt::format("{:.4f},1\n", t);
    }
    return text;
  };
  EXPECT_NEAR(host_sim::parse_csv(written(0), "d.csv", rig()).sample_period_s, 1.0 / 3000.0, 1e-9);
  EXPECT_THROW(host_sim::parse_csv(written(20000), "d.csv", rig()), host_sim::DataFileError);
  EXPECT_THROW(host_sim::parse_csv(written(200), "d.csv", rig()), host_sim::DataFileError);
}

// One time of a second among milliseconds is whole by chance: its last decimal is that of the others.
TEST(Dialects, AFewWholeTimesSayNothingOfTheirDecimals) {
  std::string text = "t_s,force_1_N\n";
  for (int i = 0; i <= 1000; ++i) text += fmt::format("{:.3f},1\n", 0.001 * i);
  EXPECT_NEAR(host_sim::parse_csv(text, "d.csv", rig()).sample_period_s, 1e-3, 1e-12);
  std::string late;
  for (int i = 0; i <= 1000; ++i) late += fmt::format("{:.3f},1\n", 0.001 * i + (i > 500 ? 0.003 : 0.0));
  EXPECT_THROW(host_sim::parse_csv("t_s,force_1_N\n" + late, "d.csv", rig()), host_sim::DataFileError);
}

// Five digits of times up to 1.999 s would allow 199.02 ms as a place of its own decade, but there a time is late by two
// of its last decimals, where rounding gives half of one.
TEST(Dialects, ATimeAmidEvenOnesIsOffByMoreThanItsLastDecimal) {
  const auto text = [](const char* two_hundredth) {
    std::string lines = "t_s,force_1_N\n";
    for (int i = 0; i < 2000; ++i)
      lines += (i == 199 ? std::string(two_hundredth) : fmt::format("{:.3f}", 1e-3 * i)) + ",1\n";
    return lines;
  };
  EXPECT_NEAR(host_sim::parse_csv(text("0.199"), "d.csv", rig()).sample_period_s, 1e-3, 1e-9);
  EXPECT_THROW(host_sim::parse_csv(text("0.19902"), "d.csv", rig()), host_sim::DataFileError);
  EXPECT_THROW(host_sim::parse_csv(text("0.1993"), "d.csv", rig()), host_sim::DataFileError);
}

// A board that samples every 10.04 ms stamps what its millisecond counter shows, and every seventh time it reads it 0.4 ms
// late: the stamps lie up to 0.56 ms before and 0.84 ms after even times.
TEST(Dialects, TimesInTicksOfAnotherClockAreEven) {
  std::string text = "t_s,force_1_N\n";
  for (int i = 0; i < 5000; ++i) {
    char row[60];
    const double late_ms = i % 7 == 3 ? 0.4 : 0.0;
    std::snprintf(row, sizeof row, "%.3f,1\n", 1e-3 * std::floor(10.04 * i + late_ms));
    text += row;
  }
  const auto record = host_sim::parse_csv(text, "d.csv", rig());
  EXPECT_NEAR(record.sample_period_s, 0.01004, 1e-8);
  // a lost sample is ten ticks, and a jitter of two ticks is none of the counter's
  const size_t row = text.find("\n", text.size() / 2), next = text.find("\n", row + 1);
  EXPECT_THROW(host_sim::parse_csv(text.substr(0, row) + text.substr(next), "d.csv", rig()), host_sim::DataFileError);
  std::string uneven = "t_s,force_1_N\n";
  for (int i = 0; i < 500; ++i) uneven += std::to_string(0.01 * i + (i % 3 == 1 ? 0.002 : 0.0)).substr(0, 5) + ",1\n";
  EXPECT_THROW(host_sim::parse_csv(uneven, "d.csv", rig()), host_sim::DataFileError);
}

TEST(Dialects, ALostSampleShowsInRoundedTimes) {
  EXPECT_THROW(host_sim::parse_csv(rounded_times(1024.0, "%.3f", 5000, 2500), "d.csv", rig()), host_sim::DataFileError);
  EXPECT_THROW(host_sim::parse_csv(rounded_times(1024.0, "%.3f", 5000, 40), "d.csv", rig()), host_sim::DataFileError);
  EXPECT_THROW(host_sim::parse_csv(rounded_times(2048.0, "%.3f", 5000, 2500), "d.csv", rig()), host_sim::DataFileError);
}

// One row twice in the middle of 20 s at 1 kHz: times of 1000.05 Hz that are rounded to 1 ms would have one such pair too, but not of the same
// values. With other values it may be that clock.
TEST(Dialects, ARowThatIsWrittenTwiceIsNoRounding) {
  for (const bool same : {true, false}) {
    std::string text = "t_s,force_1_N\n";
    for (int i = 0; i < 20000; ++i) {
      const double force = std::sin(0.07 * i) + 0.3 * std::sin(1.9 * i);
      text += fmt::format("{:.3f},{:.6f}\n", 1e-3 * i, force);
      if (i == 10000) text += fmt::format("{:.3f},{:.6f}\n", 1e-3 * i, same ? force : force + 0.01);
    }
    if (same)
      EXPECT_THROW(host_sim::parse_csv(text, "d.csv", rig()), host_sim::DataFileError);
    else
      EXPECT_NEAR(host_sim::parse_csv(text, "d.csv", rig()).sample_period_s, 1e-3, 1e-6);
  }
}

}  // namespace

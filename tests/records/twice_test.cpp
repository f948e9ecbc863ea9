// Rows that stand twice, and rows that share one time: all that is wrong is said at once.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace {

// 100 rows 12.5 ms apart, `again` of them a second time with the value + `off`; the rows from `late` on late by 3 ms.
std::string table(const std::vector<int>& again, int off, int late = 1000) {
  std::string text = "t_s,displacement_1_m\n";
  for (int i = 0; i < 100; ++i)
    for (int k = 0; k < 1 + (std::count(again.begin(), again.end(), i) > 0 ? 1 : 0); ++k)
      text += fmt::format("{:.4f},{}\n", 0.0125 * i + (i >= late ? 0.003 : 0.0), i % 7 + k * off);
  return text;
}

std::string told(const std::string& text, double resample_Hz) {
  host_sim::ReadingOptions options;
  options.resample_Hz = resample_Hz;
  try {
    const host_sim::Record record = host_sim::parse_csv(text, "d.csv", {}, options);
    return fmt::format("{} samples, {}", record.samples(), record.notes.empty() ? "" : record.notes.back());
  } catch (const host_sim::DataFileError& error) {
    return error.what();
  }
}

std::vector<int> all() {
  std::vector<int> rows(100);
  std::iota(rows.begin(), rows.end(), 0);
  return rows;
}

TEST(Twice, RowsThatAllStandTwiceAreLeftOutAndSaid) {
  for (const double resample_Hz : {0.0, 80.0})
    EXPECT_EQ(told(table(all(), 0), resample_Hz), "100 samples, left out: 100 rows that stand twice");
  const std::string said = told(table(all(), 0, 60), 0.0);  // line 122 is the first that is late
  EXPECT_NE(said.find("d.csv:122: t_s steps by 0.0155 s"), std::string::npos) << said;
}

// A spreadsheet ends in rows of commas, each the one before word by word. They are cut off, and with them what was noted of them:
// 300 rows of ends made notes of samples 101 to 399 of 100.
TEST(Twice, EmptyRowsAtTheEndAreNoneThatStandTwice) {
  for (const int empty : {1, 40, 300}) {
    std::string text = table({}, 0);
    for (int i = 0; i < empty; ++i) text += ",\n";
    EXPECT_EQ(told(text, 0.0),
              fmt::format("100 samples, left out: {} at the end that {} nothing of it",
                          empty == 1 ? "1 row" : fmt::format("{} rows", empty), empty == 1 ? "holds" : "hold"));
  }
  std::string doubled = table(all(), 0);
  for (int i = 0; i < 300; ++i) doubled += ",\n";
  EXPECT_EQ(told(doubled, 0.0), "100 samples, left out: 100 rows that stand twice");
}

// One advice, with and without --resample: it used to be asked for first, and to refuse then.
TEST(Twice, RowsOfOneTimeAreNamedAtOnce) {
  for (const int off : {0, 1})
    for (const double resample_Hz : {0.0, 80.0}) {
      const std::string one = told(table({40}, off), resample_Hz), two = told(table({40, 50}, off), resample_Hz);
      EXPECT_NE(one.find("two rows have one time (line 43); leave one of them out"), std::string::npos) << one;
      EXPECT_EQ(one.find("--resample"), std::string::npos) << one;
      EXPECT_NE(two.find("2 rows bear the time of the row before (lines 43, 54); leave them out"), std::string::npos)
          << two;
    }
  const std::string both = told(table({40}, 1, 60), 0.0);
  EXPECT_NE(both.find("leave one of them out; then --resample 80 interpolates the rest"), std::string::npos) << both;
}

// Rows to be sorted that are uneven even then are told both.
TEST(Twice, RowsToBeSortedAndUnevenOnesAreToldBoth) {
  std::string text = "t_s,displacement_1_m\n", even = text;
  for (int i = 0; i < 60; ++i) {
    const int row = i == 30 ? 31 : i == 31 ? 30 : i;
    text += fmt::format("{:.4f},{}\n", 0.0125 * row + (row % 3 == 0 ? 0.002 : 0.0), i % 7);
    even += fmt::format("{:.4f},{}\n", 0.0125 * row, i % 7);
  }
  EXPECT_NE(told(text, 0.0).find("sort them, then --resample"), std::string::npos) << told(text, 0.0);
  EXPECT_EQ(told(even, 0.0).find("--resample"), std::string::npos) << told(even, 0.0);
}

// 100 rows 12.5 ms apart in a table with a gap of 15 blank cells, rows 20 to 34, which are left out: the two rows of one
// time behind them, 60 and 61, are lines 62 and 63 of the file (the names are its first).
TEST(Twice, LinesAreThoseOfTheFileBehindRowsThatWereLeftOut) {
  for (const bool blank_start : {false, true}) {
    std::string text = "t_s,force_1_N,displacement_1_m\n";
    for (int i = 0; i < 100; ++i)
      text += fmt::format("{:.4f},{},{}\n", 0.0125 * (i == 61 ? 60 : i), i % 5,
                          (i >= 20 && i < 35) || (blank_start && i < 3) ? "" : fmt::format("{}", i % 7));
    const std::string said = told(text, 80.0);
    EXPECT_NE(said.find("d.csv:63: "), std::string::npos) << said;
    EXPECT_NE(said.find("two rows have one time (line 63)"), std::string::npos) << said;
  }
}

// Coarse ticks of a clock: a row may be the one before word by word while the sensor rests.
TEST(Twice, RowsOfACoarseClockStay) {
  std::string text = "t_s,displacement_1_m\n";
  for (int i = 0; i < 200; ++i) text += fmt::format("{:.2f},{}\n", std::floor(0.5 * i) * 0.01, i % 60 < 30 ? 0 : i % 7);
  EXPECT_EQ(told(text, 0.0).rfind("200 samples", 0), 0u) << told(text, 0.0);
}

}  // namespace

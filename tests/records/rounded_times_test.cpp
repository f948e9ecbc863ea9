// Times that were rounded as they were written.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/times/resample.hpp"

namespace {

TEST(RoundedTimes, AreNoJitter) {
  for (const double rate_Hz : {300.0, 900.0, 1024.0}) {
    std::string text = "t_s,displacement_1_m\n";
    for (int i = 0; i < 600; ++i) text += fmt::format("{:.3f},{}\n", i / rate_Hz, i % 7);
    const host_sim::Record record = host_sim::parse_csv(text, "d.csv", {});
    EXPECT_EQ(record.time_jitter_s, 0.0) << rate_Hz;
    ASSERT_EQ(record.notes.size(), 1u);
    EXPECT_EQ(record.notes[0].rfind("times are rounded to 0.001 s", 0), 0u);
  }
  std::string fine = "t_s,displacement_1_m\n", loose = fine;  // rounded by less than 1 % of a step; not rounded
  for (int i = 0; i < 600; ++i) {
    fine += fmt::format("{:.4f},{}\n", i / 70.0, i % 7);
    loose += fmt::format("{:.9f},{}\n", i / 70.0 + 5e-5 * std::sin(0.7 * i), i % 7);
  }
  EXPECT_EQ(host_sim::parse_csv(fine, "d.csv", {}).time_jitter_s, 0.0);
  EXPECT_NEAR(host_sim::parse_csv(loose, "d.csv", {}).time_jitter_s, 5e-5 / std::sqrt(2.0), 5e-6);
}

// 1 kHz in whole milliseconds: a step of two is a row that is not there, told with its line, and filled where --resample asks.
TEST(RoundedTimes, ALostRowIsNoSlowerClock) {
  const auto text_without = [](std::initializer_list<int> lost, double step_s) {
    std::string text = "t_s,displacement_1_m\n";
    for (int i = 0; i < 3000; ++i)
      if (std::find(lost.begin(), lost.end(), i) == lost.end())
        text += fmt::format("{:.3f},{}\n", i * step_s, std::sin(0.01 * i));
    return text;
  };
  const std::string one = text_without({1500}, 1e-3), three = text_without({100, 101, 2500}, 1e-3);
  for (const std::string& text : {one, three, text_without({700, 1400, 2300}, 2e-3)}) {
    try {
      host_sim::parse_csv(text, "d.csv", {});
      ADD_FAILURE() << "taken as whole";
    } catch (const host_sim::DataFileError& error) {
      EXPECT_NE(std::string(error.what()).find("--resample"), std::string::npos) << error.what();
    }
  }
  try {
    host_sim::parse_csv(one, "d.csv", {});
  } catch (const host_sim::DataFileError& error) {  // row 1501 of those left is the one after, on line 1502
    EXPECT_NE(std::string(error.what()).find("d.csv:1502"), std::string::npos) << error.what();
  }
  host_sim::ReadingOptions options;
  options.resample_Hz = 1000;
  const host_sim::Record filled = host_sim::resampled(host_sim::parse_csv(three, "d.csv", {}, options), 1000).at(0);
  ASSERT_EQ(filled.samples(), 3000u);
  EXPECT_NEAR(filled.channels[0].values[100], std::sin(1.0), 1e-6);
  EXPECT_NEAR(filled.channels[0].values[2999], std::sin(29.99), 1e-6);
}

// 998 Hz in whole milliseconds: the step of two comes after every 498th or 499th.
TEST(RoundedTimes, ASlowerClockSkipsAtEvenIntervals) {
  std::string text = "t_s,displacement_1_m\n";
  for (int i = 0; i < 3000; ++i) text += fmt::format("{:.3f},{}\n", i / 998.0, i % 7);
  EXPECT_NEAR(host_sim::parse_csv(text, "d.csv", {}).sample_period_s, 1 / 998.0, 1e-7);
}

// Seconds since 1970, of which a double holds no more than 0.2 us: in decimals, and in microseconds and nanoseconds.
TEST(RoundedTimes, OfACalendarAreEvenToo) {
  struct Written {
    const char* unit;
    double per_s;
    int decimals;
    double rate_Hz;
  };
  for (const Written& w : {Written{"s", 1, 3, 1024},
                           {"s", 1, 4, 1024},
                           {"s", 1, 5, 12800},
                           {"us", 1e6, 0, 25600},
                           {"ns", 1e9, 0, 51200}}) {
    std::string text = fmt::format("t_{},displacement_1_m\n", w.unit);
    for (int i = 0; i < 3000; ++i) {  // whole seconds and the rest, put together as text: no double holds the sum
      const double since_s = i / w.rate_Hz;
      text += w.per_s > 1 ? fmt::format("{}{:0{}.0f},{}\n", 1700000000, since_s * w.per_s, w.per_s > 1e6 ? 9 : 6, i % 7)
                          : fmt::format("170000{:0{}.{}f},{}\n", since_s, 5 + w.decimals, w.decimals, i % 7);
    }
    const host_sim::Record record = host_sim::parse_csv(text, "d.csv", {});
    EXPECT_NEAR(record.sample_period_s * w.rate_Hz, 1, 1e-5) << w.unit << " " << w.decimals;
    EXPECT_EQ(record.time_jitter_s, 0.0) << w.unit << " " << w.decimals;
  }
}

// No even step is 10 and 12 ms, to the millisecond. 10 and 11 ms are 10.5 where the motion, 2 sin 3 t, says so, and not where it is smooth at
// these very times.
TEST(RoundedTimes, ThatAlternateAreThoseOfTheMotion) {
  const auto note_of = [](int longer_ms, bool sampled_evenly) -> std::string {
    std::string text = "t_s,displacement_1_m\n";
    for (int i = 0, ms = 0; i < 600; ++i, ms += i % 2 == 0 ? longer_ms : 10) {
      const double at_s = sampled_evenly ? 5e-4 * (10 + longer_ms) * i : 1e-3 * ms;
      text += fmt::format("{:.3f},{:.9f}\n", 1e-3 * ms, 2 * std::sin(3 * at_s));
    }
    try {
      const host_sim::Record record = host_sim::parse_csv(text, "d.csv", {});
      return record.notes.empty() ? "" : record.notes[0];
    } catch (const host_sim::DataFileError& error) {
      return error.problem;
    }
  };
  for (const bool sampled_evenly : {false, true}) {
    const std::string note = note_of(12, sampled_evenly);
    EXPECT_NE(note.find("expected a constant step"), std::string::npos) << note;
    EXPECT_NE(note.find("--resample"), std::string::npos) << note;
  }
  EXPECT_NE(note_of(11, false).find("--resample"), std::string::npos) << note_of(11, false);
  EXPECT_EQ(note_of(11, true).rfind("times are rounded to 0.001 s: the step is 0.0105 s", 0), 0u) << note_of(11, true);
}

}  // namespace

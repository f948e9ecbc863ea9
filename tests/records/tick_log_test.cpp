// Logs that hold a row for each tick of an encoder.
#include "host_sim/records/steps/tick_log.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/times/resample.hpp"

namespace {

using host_sim::Record;
using host_sim::resampled;
using host_sim::tick_step;

constexpr double kStep = 0.01;

Record logged(const std::vector<double>& time_s, const std::vector<double>& counts) {
  Record record;
  record.file = "ticks.csv";
  record.time_s = time_s;
  record.channels.push_back({"angle_1_rad", host_sim::Quantity::kDisplacement, 1, {}});
  for (const double count : counts) record.channels[0].values.push_back(kStep * count);
  return record;
}

// 10.2 sin(pi t) steps over `periods` of 2 s. It passes the edges at -9.5 to 9.5 steps: up to count edge + 0.5 at asin(edge / 10.2) / pi
// from each whole period on, down to edge - 0.5 at 1 s less that.
constexpr double kHeight = 10.2;
Record swings(int periods) {
  std::vector<double> time_s, counts;
  for (int n = 0; n < 2 * periods; ++n)
    for (int k = 0; k < 20; ++k) {
      const double edge = n % 2 == 0 ? k - 9.5 : 9.5 - k, at = std::asin((k - 9.5) / kHeight) / M_PI;
      time_s.push_back(n + at), counts.push_back(n % 2 == 0 ? edge + 0.5 : edge - 0.5);
    }
  return logged(time_s, counts);
}

double true_at(double t) { return kStep * kHeight * std::sin(M_PI * t); }

// Between turns ticks pass 32 times a second at the fastest and 7 times slower at the turns: no rate, and no gap.
TEST(TickLog, IsReadAtAnyRateThatItsMotionNeeds) {
  for (const double rate_Hz : {8.0, 50.0, 400.0}) {
    const std::vector<Record> records = resampled(swings(5), rate_Hz);
    ASSERT_EQ(records.size(), 1u);
    const Record& record = records[0];
    EXPECT_NEAR(static_cast<double>(record.samples()), 9.8 * rate_Hz, 0.2 * rate_Hz);
    EXPECT_NEAR(record.channels[0].recorded_step, kStep, 1e-12);
    double worst = 0.0;
    for (size_t i = 0; i < record.samples(); ++i) {
      const double t = record.start_s + static_cast<double>(i) / rate_Hz;
      worst = std::max(worst, std::abs(record.channels[0].values[i] - true_at(t)));
    }
    EXPECT_LT(worst, 0.05 * kStep) << rate_Hz;  // without a word on the edges up and down would lie half a step apart
    EXPECT_NE(record.notes.back().find("each of its 200 rows is one step of 0.01 up or down"), std::string::npos)
        << record.notes.back();
  }
}

// Two turns in 2 s: 4 samples for each are 4 a second.
TEST(TickLog, ARateThatDoesNotShowTheMotionIsRefused) {
  try {
    resampled(swings(50), 3.0);
    ADD_FAILURE() << "taken";
  } catch (const host_sim::DataFileError& error) {
    EXPECT_NE(error.problem.find("expected --resample 4 or more"), std::string::npos) << error.problem;
  }
}

// 70 ticks up, 100 s of rest, 70 down: all the while the encoder stands at count 70, between 69.5 and 70.5 steps.
TEST(TickLog, ARestIsNoGapAndStaysWithinItsStep) {
  std::vector<double> time_s, counts;
  for (int i = 0; i < 140; ++i) {
    time_s.push_back(0.01 * i + (i > 70 ? 100.0 : 0.0));
    counts.push_back(i <= 70 ? i : 140 - i);
  }
  const std::vector<Record> records = resampled(logged(time_s, counts), 20.0);
  ASSERT_EQ(records.size(), 1u);
  for (size_t i = 0; i < records[0].samples(); ++i) {
    const double t = records[0].start_s + 0.05 * static_cast<double>(i);
    if (t < 0.7 || t > 100.7) continue;
    EXPECT_GE(records[0].channels[0].values[i], 69.5 * kStep - 1e-12);
    EXPECT_LE(records[0].channels[0].values[i], 70.5 * kStep + 1e-12);
  }
}

TEST(TickLog, ALostTickIsTwoStepsAtOnce) {
  Record record = swings(5);
  record.time_s.erase(record.time_s.begin() + 50);
  auto& values = record.channels[0].values;
  values.erase(values.begin() + 50);
  EXPECT_NEAR(tick_step(record), kStep, 1e-12);
  for (int i = 0; i < 5; ++i) values.erase(values.begin() + 10 + 20 * i), record.time_s.pop_back();
  EXPECT_EQ(tick_step(record), 0.0);  // 6 of 200 are no logger's slip
}

// A wheel that turns one way is exact at its marks; of two channels the other is sampled where the first one ticks.
TEST(TickLog, WhatDoesNotTurnOrIsNotAloneIsNone) {
  std::vector<double> time_s, counts;
  for (int i = 0; i < 100; ++i) time_s.push_back(0.01 * i), counts.push_back(i);
  EXPECT_EQ(tick_step(logged(time_s, counts)), 0.0);
  EXPECT_TRUE(host_sim::counts_marks(time_s, counts));
  Record two = swings(5);
  two.channels.push_back(two.channels[0]);
  EXPECT_EQ(tick_step(two), 0.0);
  Record rests = swings(5);
  rests.channels[0].values[30] = rests.channels[0].values[29];
  EXPECT_EQ(tick_step(rests), 0.0);  // a sample at which nothing passed
}

// A wheel that slows down passes mark n at t = 100 (1 - sqrt(1 - n / 500)) s. A row that misses one, two or three takes as many times longer, and
// is as exact. The same revolutions read every 0.3 s and rounded to whole ones have steps of 1 and 2 in the same time.
TEST(TickLog, MarksThatWereMissedLeaveTheOthersExact) {
  std::vector<double> time_s, marks;
  for (int n = 0; n < 300; n += n % 7 == 3 ? 4 : n % 5 == 1 ? 2 : 1)
    time_s.push_back(100.0 * (1.0 - std::sqrt(1.0 - n / 500.0))), marks.push_back(n);
  EXPECT_TRUE(host_sim::counts_marks(time_s, marks));
  std::vector<double> backwards = marks;
  for (double& value : backwards) value = -value;
  EXPECT_TRUE(host_sim::counts_marks(time_s, backwards));
  std::vector<double> even_s, rounded;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.16 * i, left = 1.0 - t / 100.0;
    even_s.push_back(t), rounded.push_back(std::round(500.0 * (1.0 - left * left)));
  }
  EXPECT_FALSE(host_sim::counts_marks(even_s, rounded));
}

}  // namespace

// Channels whose sensor updates more slowly than the rows come.
#include "host_sim/data_check/channel/staircase.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/records/steps/updates.hpp"
#include "host_sim/records/times/resample.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::Finding;
using host_sim::data_check::Weight;

constexpr double kRate_Hz = 500.0;

// 20 s of a speed of two tones in 1 mm/s, rests in between, read anew in rows of that distance (on the mean, where it is no whole
// number) and rounded to steps.
Record speed(double rows, double step, double noise = 0.0) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Record record;
  record.file = "made.csv", record.sample_period_s = 1.0 / kRate_Hz;
  record.channels = {{"velocity_1_m_s", Quantity::kVelocity, 1, {}}};
  double next = 0.0, read = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double t = i / kRate_Hz, moves = std::fmod(t, 5.0) < 3.0 ? 1.0 : 0.0;
    if (i >= next) {
      read = moves * (std::sin(2 * M_PI * 1.1 * t) + 0.4 * std::sin(2 * M_PI * 3.7 * t)) + noise * normal(random);
      read = 1e-3 * (step > 0.0 ? step * std::nearbyint(read / step) : read), next += rows;
    }
    record.channels[0].values.push_back(read);
  }
  return record;
}

std::optional<Finding> found(const Record& record) {
  const host_sim::Channel& channel = record.channels[0];
  return host_sim::data_check::find_staircase(record, channel, host_sim::data_check::statistics_of(channel));
}

TEST(Staircase, ToldWithItsRate) {
  for (const double rows : {2.0, 2.5, 5.0, 12.0})
    for (const double step : {0.0, 1e-3}) {
      const std::optional<Finding> finding = found(speed(rows, step));
      ASSERT_TRUE(finding) << rows << " " << step;
      EXPECT_NEAR(*finding->value, rows, 0.1 * rows) << step;
      EXPECT_EQ(finding->weight, rows > 4 ? Weight::kDoubt : finding->weight);
      EXPECT_NE(finding->detail.find("--resample 500"), std::string::npos) << finding->detail;
    }
  EXPECT_TRUE(found(speed(5.0, 1e-3, 0.01)));
}

TEST(Staircase, IsNoCoarseNorNoisyNorRestingSignal) {
  for (const double step : {0.0, 1e-3, 0.02, 0.2})
    for (const double noise : {0.0, 0.3, 1.0, 3.0})
      EXPECT_FALSE(found(speed(1.0, step, noise * step))) << step << " " << noise;
}

TEST(Staircase, ASquareWaveAndABlowNowAndThenAreNone) {
  Record record = speed(1.0, 0.0);
  std::vector<double>& v = record.channels[0].values;
  for (size_t i = 0; i < v.size(); ++i) v[i] = i / 50 % 2 == 0 ? 1.0 : -1.0;
  EXPECT_FALSE(found(record));
  for (size_t i = 0; i < v.size(); ++i) v[i] = i % 100 == 7 ? 1e-3 * static_cast<double>(i) : 0.0;
  EXPECT_FALSE(found(record));
}

TEST(Staircase, AForceIsACommandAndIsHeld) {
  Record record = speed(5.0, 0.0);
  record.channels[0].quantity = Quantity::kForce;
  EXPECT_FALSE(found(record));
}

// 7 levels of 1 cm that are crossed every tenth row or so, a fourth of the zeros written in full: as rows stay, so does the motion, and a
// step to the next level is no dropout.
TEST(Staircase, ACoarseConverterIsNoneNorDoesItDropOut) {
  Record record;
  record.file = "made.csv", record.sample_period_s = 0.01;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, {}}};
  for (int i = 0; i < 20000; ++i) {
    const double x = 0.034 * std::sin(2 * M_PI / 150 * i) * std::exp(-2e-5 * i), rounded = 0.01 * std::round(100 * x);
    record.channels[0].values.push_back(rounded == 0.0 && i % 4 == 0 ? 1e-6 * std::round(1e6 * x) : rounded);
  }
  const auto report = host_sim::data_check::check({record}, nullptr);
  EXPECT_EQ(report.worst(), Weight::kInforms);
  EXPECT_NEAR(report.records[0].channels[0].resolution, 0.01, 1e-6);
}

// A pulse counter's speed, held for 20 rows each: at the reversal it stands still. The same value between two equal ones is a dropout.
TEST(Staircase, AStandstillAtTheReversalIsNoDropout) {
  for (const bool reverses : {true, false}) {
    Record record;
    record.file = "made.csv", record.sample_period_s = 1e-3;
    record.channels = {{"angular_velocity_1_rad_s", Quantity::kVelocity, 1, {}}};
    for (int i = 0; i < 4000; ++i) {
      const int held = i / 20;
      const double speed = held < 100 ? 40.0 + held % 3 : (reverses ? -1 : 1) * (45.0 + held % 3);
      record.channels[0].values.push_back(held == 100 ? 0.0 : speed);
    }
    const auto report = host_sim::data_check::check({record}, nullptr);
    bool dropout = false;
    for (const Finding& f : report.records[0].channels[0].findings)
      dropout = dropout || f.detail.find("dropout") != std::string::npos;
    EXPECT_NE(dropout, reverses);
  }
}

// Interpolation rounds the stairs off; it is told all the same.
TEST(Staircase, IsToldOfResampledRowsToo) {
  for (const double rate_Hz : {500.0, 1000.0}) {
    const std::optional<Finding> finding = found(host_sim::resampled(speed(5.0, 1e-3), rate_Hz).front());
    ASSERT_TRUE(finding) << rate_Hz;
    EXPECT_NEAR(*finding->value, 5.0 * rate_Hz / kRate_Hz, 0.5 * rate_Hz / kRate_Hz);
  }
}

}  // namespace

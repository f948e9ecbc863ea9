// Mains hum by what it does to the estimation.
#include "host_sim/data_check/channel/hum_weight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::hum_share;
using host_sim::data_check::Weight;

constexpr double kTurn = 6.283185307179586;

// 20 s at 1 kHz of 20 mm at 2 Hz with 1 mm at 60 Hz, under a force of 2 Hz that has `driven` of its own amplitude at 60 Hz.
Record humming(Quantity of, double driven = 0.0) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  const double way = of == Quantity::kAcceleration ? -1.0 : 1.0;  // of a force in step with the velocity
  Record record;
  record.file = "made.csv", record.sample_period_s = 1e-3;
  const char* const name = of == Quantity::kDisplacement ? "displacement_1_m"
                           : of == Quantity::kVelocity   ? "velocity_1_m_s"
                                                         : "acceleration_1_m_s2";
  record.channels = {{"force_1_N", Quantity::kForce, 1, {}}, {name, of, 1, {}}};
  for (int i = 0; i < 20000; ++i) {
    const double t = 1e-3 * i, hum = std::sin(kTurn * 60 * t);
    record.channels[0].values.push_back(std::cos(kTurn * 2 * t) + driven * hum + 1e-4 * noise(random));
    record.channels[1].values.push_back(way * 0.02 * std::sin(kTurn * 2 * t) + 0.001 * hum + 1e-6 * noise(random));
  }
  return record;
}

TEST(HumWeight, GoesWithTheFrequencyAsOftenAsItIsDifferentiated) {
  // (1 mm / 20 mm)^2 = 0.0025, times 30^2 for each time.
  const Record record = humming(Quantity::kDisplacement);
  const auto share = [&](int differentiated) {
    return hum_share(record, record.channels[1], 0.001, 60.0, differentiated);
  };
  EXPECT_NEAR(share(0), 0.0025, 5e-5);
  EXPECT_NEAR(share(1), 2.25, 0.05);
  EXPECT_NEAR(share(2), 2025.0, 50.0);
  // A force with 1 % of it (0.05 of the motion's share is 0.0025) may drive the rig there.
  const Record driven = humming(Quantity::kDisplacement, 0.01);
  EXPECT_EQ(hum_share(driven, driven.channels[1], 0.001, 60.0, 2), 0.0);
}

TEST(HumWeight, IsADoubtWhereItOutdoesTheMotion) {
  const auto check_of = [](const Record& record) { return host_sim::data_check::check({record}, nullptr); };
  const auto alone = check_of(humming(Quantity::kDisplacement));
  EXPECT_STREQ(alone.verdict(), "usable");
  EXPECT_EQ(host_sim::data_check::spoilt_by_hum(alone), "displacement_1_m");
  // An accelerometer with as much is used as it is, and a line of the drive is no hum.
  const auto accelerometer = check_of(humming(Quantity::kAcceleration)),
             driven = check_of(humming(Quantity::kDisplacement, 0.01));
  for (const auto& report : {accelerometer, driven}) {
    EXPECT_STREQ(report.verdict(), "good");
    EXPECT_EQ(host_sim::data_check::spoilt_by_hum(report), "");
  }
}

}  // namespace

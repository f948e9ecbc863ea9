// The work of the forces tells signs that nothing else does.
#include "host_sim/data_check/drive/work.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/data_check/drive/one_sign.hpp"
#include "tests/data_check/made_records.hpp"

namespace {

using host_sim::Channel;
using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::Weight;

constexpr double kPi = 3.14159265358979323846;

// 10 s at 1 kHz of x = 10 mm sin(2 pi 2 Hz t) under the force f = k x(t - delay) + c v; the motion as `of` says.
Record lone_link(double stiffness, double viscous, double delay_s, Quantity of) {
  const double w = 2 * kPi * 2;
  Record record;
  record.file = "made.csv", record.sample_period_s = 1e-3;
  Channel force{"force_1_N", Quantity::kForce, 1, {}}, motion{"motion_1", of, 1, {}};
  for (int i = 0; i < 10000; ++i) {
    const double t = i * 1e-3, x = 0.01 * std::sin(w * t), v = 0.01 * w * std::cos(w * t);
    force.values.push_back(stiffness * 0.01 * std::sin(w * (t - delay_s)) + viscous * v);
    motion.values.push_back(of == Quantity::kDisplacement ? x : of == Quantity::kVelocity ? v : -w * w * x);
  }
  record.channels = {force, motion};
  return record;
}

auto find_negative_work(const Record& record) {
  return host_sim::data_check::find_negative_work(record, host_sim::data_check::drive_of(record));
}

TEST(Work, OfADamperTurnedOver) {
  // k x and c v of one size, a quarter of a period apart: the power factor is cos 45 degrees.
  const double k = 1000, c = 1000 / (2 * kPi * 2);
  for (const Quantity of : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration}) {
    EXPECT_FALSE(find_negative_work(lone_link(k, c, 0, of)));
    const auto found = find_negative_work(lone_link(-k, -c, 0, of));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kind, "polarity");
    EXPECT_EQ(found->weight, Weight::kDoubt);  // its sign is all there is to change
    EXPECT_EQ(found->channel, "force_1_N");
    EXPECT_NEAR(*found->value, -std::sqrt(0.5), 0.01);
  }
}

// 10 s at 1 kHz of a motor that a controller holds at 3 rad/s + u against a load: v = 3 + u, T = T0 - u with u = 0.3 sin(2 pi 2 Hz t), signs
// right. About the means the power factor is -1. As measured the mean power is 3 T0 - 0.3^2 / 2 = 3 T0 - 0.045.
Record held_speed(double mean_torque) {
  Record record;
  record.file = "made.csv", record.sample_period_s = 1e-3;
  Channel torque{"torque_1_N_m", Quantity::kForce, 1, {}},
      speed{"angular_velocity_1_rad_s", Quantity::kVelocity, 1, {}};
  for (int i = 0; i < 10000; ++i) {
    const double u = 0.3 * std::sin(4 * kPi * i * 1e-3);
    torque.values.push_back(mean_torque - u);
    speed.values.push_back(3 + u);
  }
  record.channels = {torque, speed};
  return record;
}

TEST(Work, OfAControllerThatHoldsASpeedIsWhatItsMeanDoes) {
  EXPECT_FALSE(find_negative_work(held_speed(1)));
  EXPECT_FALSE(find_negative_work(held_speed(0.02)));  // 0.06 - 0.045 > 0
  Record over = held_speed(1);
  for (double& value : over.channels[0].values) value = -value;
  // -(3 - 0.045) over sqrt(1 + 0.045) sqrt(9 + 0.045): -0.961. The zero of a torque sensor explains it, too: no sign is changed.
  const auto found = find_negative_work(over);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "work");
  EXPECT_EQ(found->weight, Weight::kDoubt);
  EXPECT_NEAR(*found->value, -0.961, 0.01);
}

TEST(Work, OfAMotorTurnedOver) {
  // The torque that such a motor needs for J dv/dt + c v, turned over: both ways the power is negative.
  Record record = lone_link(0, -10, 0, Quantity::kVelocity);
  for (size_t i = 0; i < record.samples(); ++i) record.channels[0].values[i] -= 10, record.channels[1].values[i] += 1;
  EXPECT_EQ(find_negative_work(record)->kind, "polarity");
  // A load cell that bears ten times the weight of what it measures does no work with it: the rig stays where it is.
  for (const double sign : {1.0, -1.0}) {
    record = lone_link(-1000, -1000 / (4 * kPi), 0, Quantity::kDisplacement);
    for (double& value : record.channels[0].values) value += sign * 100;
    ASSERT_TRUE(find_negative_work(record));
    EXPECT_EQ(find_negative_work(record)->kind, "polarity");
  }
}

// A torque of -1 N m that trembles by a tenth, a quarter of a period beside the speed.
TEST(Work, OfABrakeIsWhatTheFlywheelHad) {
  Record record = held_speed(0);
  for (size_t i = 0; i < record.samples(); ++i) {
    const double t = static_cast<double>(i) * 1e-3;
    record.channels[0].values[i] = -1 - 0.1 * std::cos(4 * kPi * t);
    record.channels[1].values[i] = 10 - 0.9 * t;
  }
  EXPECT_FALSE(find_negative_work(record));
  record.channels[1].values = held_speed(0).channels[1].values;  // it does not slow down: something else drives it
  ASSERT_TRUE(find_negative_work(record));
  EXPECT_EQ(find_negative_work(record)->kind, "work");
}

TEST(Work, OfASpringWhoseForceIsLate) {
  // sin(wt - a) cos(wt) has the mean -sin(a) / 2: the power factor is -sin(a). Here a = 2 pi 2 Hz 15.9 ms = 0.2.
  const auto found = find_negative_work(lone_link(1000, 0, 0.2 / (4 * kPi), Quantity::kDisplacement));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "work");
  EXPECT_EQ(found->weight, Weight::kDoubt);
  EXPECT_NEAR(*found->value, -std::sin(0.2), 0.01);
  EXPECT_FALSE(find_negative_work(lone_link(1000, 0, -0.01, Quantity::kDisplacement)));  // early: it only takes more
  EXPECT_FALSE(find_negative_work(lone_link(1000, 0, 0, Quantity::kDisplacement)));      // neither gives nor takes
}

TEST(Work, TurnsAForceOverThatAllRecordsSay) {
  using host_sim::data_check::check;
  using host_sim::data_check::turn_over;
  const Record over = lone_link(-1000, -100, 0, Quantity::kVelocity),
               right = lone_link(1000, 100, 0, Quantity::kVelocity);
  std::vector<Record> records = {over, over};
  ASSERT_TRUE(turn_over(check(records, nullptr), records));
  for (const Record& record : records) {
    EXPECT_EQ(record.channels[0].values, right.channels[0].values);
    EXPECT_EQ(record.channels[1].values, over.channels[1].values);
  }
  EXPECT_FALSE(turn_over(check(records, nullptr), records));
  // A sign is of the cable: in one record of two it is a fault, and nothing is changed.
  records = {over, right};
  const auto report = check(records, nullptr);
  EXPECT_EQ(report.worst(), Weight::kFault);
  EXPECT_EQ(report.records[0].channels[0].findings.at(0).weight, Weight::kFault);
  EXPECT_FALSE(turn_over(report, records));
  EXPECT_EQ(records[0].channels[0].values, over.channels[0].values);
}

// A fifth of a second beside ten: its parts are a part of a swing each, and say neither. The sign is that of the other.
TEST(Work, OneTooShortToSayNeedNot) {
  using host_sim::data_check::check;
  using host_sim::data_check::turn_over;
  const Record over = lone_link(-1000, -100, 0, Quantity::kVelocity);
  Record brief = over;
  for (Channel& channel : brief.channels) channel.values.resize(200);
  std::vector<Record> records = {over, brief};
  const auto report = check(records, nullptr);
  EXPECT_NE(report.worst(), Weight::kFault);
  ASSERT_TRUE(turn_over(report, records));
  EXPECT_EQ(records[1].channels[0].values[50], -brief.channels[0].values[50]);
}

TEST(Work, OfTwoShakersIsTheirSum) {
  // One drives with 3 c v, the other brakes with -c v: together they give.
  Record record = lone_link(0, 30, 0, Quantity::kVelocity);
  for (Channel channel : lone_link(0, -10, 0, Quantity::kVelocity).channels) {
    channel.name[channel.name.find('1')] = '2', channel.dof = 2;
    record.channels.push_back(channel);
  }
  EXPECT_FALSE(find_negative_work(record));
  for (Channel& channel : record.channels)  // now the strong one brakes
    if (channel.quantity == Quantity::kForce)
      for (double& value : channel.values) value = -value;
  const auto found = find_negative_work(record);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->channel, "");  // which of them is turned over, the sum cannot tell
}

TEST(Work, TellsNothingBesideAMovingBase) {
  Record record = lone_link(-1000, -100, 0, Quantity::kVelocity);
  record.channels.push_back({"displacement_base_m", Quantity::kDisplacement, -1, record.channels[1].values});
  EXPECT_FALSE(find_negative_work(record));
}

// A chain of two masses of which no rig file tells anything.
TEST(Work, OfARigWithoutARigFile) {
  for (const made::Drive drive : {made::Drive::kRandom, made::Drive::kTwoTones, made::Drive::kSweep})
    for (const char* sensors : {"xva", "x", "v", "a"})
      for (const double noise : {0.0, 0.05}) {
        made::Options options;
        options.drive = drive, options.sensors = sensors, options.noise = noise, options.seed = 31;
        Record record = made::record(options);
        EXPECT_FALSE(find_negative_work(record)) << static_cast<int>(drive) << sensors << noise;
        if (drive == made::Drive::kSweep) continue;  // a resonance on its way gives back what it took: nothing is said
        for (double& value : made::values(record, "force_1_N")) value = -value;
        EXPECT_TRUE(find_negative_work(record)) << static_cast<int>(drive) << sensors << noise;
      }
}

// Records are checked in threads of their own: nothing that they share may break.
TEST(Work, OfManyRecordsAtOnce) {
  const Record whole = lone_link(-1000, -100, 0, Quantity::kVelocity);
  std::vector<Record> records(64, whole);  // each of its own length: a transform of its own
  for (size_t i = 0; i < records.size(); ++i)
    for (Channel& channel : records[i].channels) channel.values.resize(whole.samples() - 70 * i);
  for (const auto& record : host_sim::data_check::check(records, nullptr).records)
    EXPECT_EQ(record.channels[0].findings.at(0).kind, "polarity");
}

// Noise that has nothing to do with the force, in place of the motion: chance alone.
TEST(Work, OfNoiseIsNothing) {
  std::mt19937 random(77);
  std::normal_distribution<double> normal;
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    Record record = lone_link(1000, 10, 0, Quantity::kVelocity);
    for (double& value : record.channels[1].values) value = normal(random);
    found += find_negative_work(record).has_value();
  }
  EXPECT_LE(found, 2);  // one in 1,024 is promised: more than two of 200 come in one of 1,000 repetitions
}

}  // namespace

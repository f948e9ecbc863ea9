// Free decays whose start, or whose blow, is beyond a channel's range: what is left behind it is a decay still.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/decay/free_decays.hpp"
#include "host_sim/data_check/decay/release.hpp"

namespace {

using host_sim::Channel;
using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::free_decays;
using host_sim::data_check::keep_decays;

constexpr double kTurn = 2 * 3.14159265358979323846 * 3.0;  // 3 Hz
constexpr size_t kPeriod = 33;                              // samples at 100 Hz

double decay(double t) { return std::exp(-t / 3) * std::cos(kTurn * t); }

// 12 s at 100 Hz of y(t), cut off at +-limit, with noise of 1 % of one in front of that.
Channel channel_of(const char* name, Quantity quantity, const std::function<double(double)>& y, double limit) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.01);
  Channel channel{name, quantity, 1, {}};
  for (int i = 0; i < 1200; ++i)
    channel.values.push_back(std::min(limit, std::max(-limit, y(0.01 * i) + noise(random))));
  return channel;
}
Record record_of(std::vector<Channel> channels) {
  Record record;
  record.file = "made.csv", record.sample_period_s = 0.01, record.channels = std::move(channels);
  return record;
}

// The tops lie k / 6 s after the release and pass a half until exp(-2.08 / 3) = 0.5, the last one at 2.0 s (0.513; the
// next, at 2.167 s, is 0.486). It ends where 0.513 cos(6 pi s) = 0.5: s = 0.012 s; noise may hide or add a sample. A
// quarter to half a period more is lost.
TEST(ClippedDecay, BeginsBehindItsClippedStart) {
  const std::pair<const char*, Quantity> kinds[] = {{"displacement_1_m", Quantity::kDisplacement},
                                                    {"velocity_1_m_s", Quantity::kVelocity},
                                                    {"acceleration_1_m_s2", Quantity::kAcceleration}};
  for (const auto& [name, quantity] : kinds) {
    SCOPED_TRACE(name);
    const auto decays = free_decays(record_of({channel_of(name, quantity, decay, 0.5)}));
    ASSERT_EQ(decays.size(), 1u);
    EXPECT_GE(decays[0].from, 200 + kPeriod / 4);
    EXPECT_LE(decays[0].from, 203 + kPeriod / 2 + 1);
    EXPECT_EQ(decays[0].to, 1200u);
    EXPECT_EQ(free_decays(record_of({channel_of(name, quantity, decay, 2.0)})).front().from, 0u);
    // cut off at a fiftieth it is clipped until t = 3 ln 50 = 11.7 s: less than four periods are left
    EXPECT_TRUE(free_decays(record_of({channel_of(name, quantity, decay, 0.02)})).empty());
  }
}

// 50 ms of 50 in an accelerometer that ends at 3; 2 exp(-t / 3) follows. The displacement beside it, which is not
// clipped, begins with it, and the note tells why.
TEST(ClippedDecay, BeginsBehindItsClippedBlow) {
  const auto free = [](double t) { return t < 1.55 ? 0.0 : 2 * decay(t - 1.55); };
  const auto felt = [&](double t) { return t < 1.5 || t >= 1.55 ? free(t) : 50.0; };
  std::vector<Record> records = {record_of({channel_of("displacement_1_m", Quantity::kDisplacement, free, 9),
                                            channel_of("acceleration_1_m_s2", Quantity::kAcceleration, felt, 3)})};
  const auto told = keep_decays(records);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("a channel is at the end of its range"), std::string::npos) << told[0];
  EXPECT_GE(records[0].start_s, 1.55);
  EXPECT_LE(records[0].start_s, 1.55 + 0.01 * (1.5 * kPeriod + 1));
  EXPECT_EQ(records[0].channels[0].values.size(), records[0].channels[1].values.size());
}

// Two blows at 0.5 and 6 s, both beyond the range: each decay begins behind its own, and none holds a clipped sample.
TEST(ClippedDecay, OfTwoBlowsEachBeginsBehindItsOwn) {
  const auto y = [](double t) {
    double sum = 0;
    for (const double blow : {0.5, 6.0})
      if (t > blow) sum += std::exp((blow - t) / 1.5) * std::sin(kTurn * (t - blow));
    return sum;
  };
  std::vector<Record> records = {record_of({channel_of("velocity_1_m_s", Quantity::kVelocity, y, 0.6)})};
  keep_decays(records);
  ASSERT_EQ(records.size(), 2u);
  EXPECT_GT(records[1].start_s, 6.0);
  for (const Record& record : records)
    for (const double value : record.channels[0].values) EXPECT_LT(std::abs(value), 0.6);
}

// The check says what it saw and that it harms nobody. Where nothing is left behind it, it does.
TEST(ClippedDecay, IsNoFaultOfTheRecording) {
  using host_sim::data_check::check;
  const auto record = [](double limit) {
    return record_of({channel_of("displacement_1_m", Quantity::kDisplacement, decay, limit)});
  };
  const auto report = check({record(0.5)}, nullptr);
  EXPECT_STREQ(report.verdict(), "good");
  ASSERT_EQ(report.records[0].channels[0].findings.size(), 1u);
  EXPECT_EQ(report.records[0].channels[0].findings[0].kind, "clipped");
  EXPECT_STREQ(check({record(0.02)}, nullptr).verdict(), "unusable");
  // a force that drives it all along makes it no free decay
  Record driven = record(0.5);
  driven.channels.push_back(channel_of(
      "force_1_N", Quantity::kForce, [](double t) { return std::sin(9 * t); }, 9));
  EXPECT_STREQ(check({driven}, nullptr).verdict(), "unusable");
}

}  // namespace

// Harmonics of the motion at the mains' frequency, and hum there.
#include "host_sim/data_check/channel/harmonic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "host_sim/data_check/channel/slow_faults.hpp"

namespace {

using host_sim::Channel;
using host_sim::Quantity;

constexpr double kTurn = 6.283185307179586;

// 20 s at 1 kHz.
Channel channel_of(const std::function<double(double)>& value) {
  Channel channel{"acceleration_1_m_s2", Quantity::kAcceleration, 1, {}};
  for (int i = 0; i < 20000; ++i) channel.values.push_back(value(1e-3 * i));
  return channel;
}

// A tone of 4 Hz and a square wave of a tenth, as dry friction makes it: 1.2732 / n of the tenth in the odd harmonics, 0.0085 at 60 Hz.
double rubbing(double t) { return std::sin(kTurn * 4 * t) + (std::cos(kTurn * 4 * t + 0.3) > 0 ? 0.1 : -0.1); }
double mains(double t) { return 0.0085 * std::sin(kTurn * 60 * t); }

size_t hums_in(const Channel& channel) {
  host_sim::Record record;
  record.sample_period_s = 1e-3, record.channels = {channel};
  size_t count = 0;
  for (const auto& finding :
       host_sim::data_check::find_slow_faults(record, channel, host_sim::data_check::statistics_of(channel), 1))
    count += finding.kind == "hum";
  return count;
}

TEST(Harmonic, OfFrictionIsNoHum) {
  const Channel channel = channel_of(rubbing);
  EXPECT_TRUE(host_sim::data_check::is_harmonic(channel, 0.0, 1e-3, 60.0));
  EXPECT_EQ(hums_in(channel), 0u);
}

TEST(Harmonic, HumStandsAlone) {
  const Channel beside_a_tone = channel_of([](double t) { return std::sin(kTurn * 4 * t) + mains(t); });
  EXPECT_FALSE(host_sim::data_check::is_harmonic(beside_a_tone, 0.0, 1e-3, 60.0));
  EXPECT_EQ(hums_in(beside_a_tone), 1u);
  // 60 Hz is no multiple of 4.1 Hz
  const Channel beside_friction = channel_of([](double t) { return rubbing(1.025 * t) + mains(t); });
  EXPECT_FALSE(host_sim::data_check::is_harmonic(beside_friction, 0.0, 1e-3, 60.0));
  EXPECT_EQ(hums_in(beside_friction), 1u);
}

// Ten times what friction has at the fifteenth harmonic.
TEST(Harmonic, HumThatOutdoesTheSeriesIsHum) {
  const Channel channel = channel_of([](double t) { return rubbing(t) + 10 * mains(t); });
  EXPECT_FALSE(host_sim::data_check::is_harmonic(channel, 0.0, 1e-3, 60.0));
  EXPECT_EQ(hums_in(channel), 1u);
}

}  // namespace

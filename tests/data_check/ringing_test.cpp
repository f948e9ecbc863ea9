// A burst of a few samples a period is a motion; single values beside each other are spikes.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/data_check/spikes/spikes.hpp"
#include "tests/data_check/made_records.hpp"

namespace {

using namespace host_sim::data_check;

bool has_spikes(const host_sim::Channel& channel) {
  host_sim::Record record;
  record.sample_period_s = 0.1;
  record.channels = {channel};
  return find_spikes(channel, statistics_of(channel), {record, 1, 0.0, 0.0, {}}).has_value();
}

// A swing of 60 to 120 samples a period that dies, with noise of 0.002 or 0.01 of it, and a burst of a twentieth to three tenths of it.
host_sim::Channel with_a_burst(double period, double periods, unsigned seed) {
  std::mt19937 random(seed * 13 + static_cast<unsigned>(10 * period));
  std::normal_distribution<double> noise(0.0, seed % 2 ? 0.002 : 0.01);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double at = 300 + 1500 * share(random), phase = 2 * M_PI * share(random), height = 0.05 + 0.25 * share(random),
               swing = 60 + 60 * share(random);
  host_sim::Channel channel{"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, {}};
  for (int i = 0; i < 2600; ++i) {
    const double since = (i - at) / (periods * period);
    const double burst = seed % 4 < 2 ? std::exp(-since * since)
                         : i > at     ? std::exp(-since)
                                      : 0.0;  // or a blow's decay
    channel.values.push_back(std::exp(-i / 1500.0) * std::sin(2 * M_PI * i / swing) +
                             height * burst * std::sin(2 * M_PI * i / period + phase) + noise(random));
  }
  return channel;
}

// One in twenty; without a look beside the stretch it was one in six, and at 3.5 samples a period every second.
TEST(Ringing, OfAFewSamplesAPeriodIsNoRowOfSpikes) {
  int taken = 0, all = 0;
  for (const double period : {2.7, 3.0, 3.5, 4.0, 4.3, 5.0, 6.0, 8.0})
    for (const double periods : {2.0, 4.0, 10.0})
      for (unsigned seed = 1; seed <= 60; ++seed, ++all) taken += has_spikes(with_a_burst(period, periods, seed));
  EXPECT_EQ(all, 1440);
  EXPECT_LE(taken, 80);
}

// Of one to three samples and as high as the signal's rms: alone, four in a row with 8 to 15 samples between, and pairs 10 apart.
TEST(Ringing, SpikesBesideEachOtherAreNone) {
  for (const made::Drive drive : {made::Drive::kRandom, made::Drive::kTwoTones, made::Drive::kDecay})
    for (unsigned seed = 1; seed <= 12; ++seed)
      for (const int kind : {0, 1, 2}) {
        host_sim::Record record = made::record({drive, "x", seed % 2 ? 1e-3 : 1e-2, 0.0, 1000.0, 5.0, 0.0, seed});
        std::vector<double>& values = made::values(record, "displacement_1_m");
        const double rms = mean_and_rms(values).rms;
        std::mt19937 random(seed);
        size_t at = 100 + random() % (values.size() - 300);
        const size_t width = 1 + seed % 3, count = kind == 0 ? 1 : kind == 1 ? 4 : 2;
        for (size_t k = 0; k < count; ++k, at += kind == 1 ? 8 + random() % 8 : 10)
          for (size_t j = 0; j < width; ++j) values[at + j] += (kind == 1 && random() % 2 ? -1 : 1) * rms;
        const auto channel = std::find_if(record.channels.begin(), record.channels.end(),
                                          [](const auto& c) { return c.name == "displacement_1_m"; });
        EXPECT_TRUE(has_spikes(*channel)) << "kind " << kind << " seed " << seed;
      }
}

}  // namespace

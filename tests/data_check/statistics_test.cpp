// What a channel says about itself, against the definitions.
#include "host_sim/data_check/measures/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/data_check/measures/quantile.hpp"

namespace {

using namespace host_sim;
using namespace host_sim::data_check;

Channel noisy_swing(size_t samples) {
  std::mt19937 random(static_cast<unsigned>(samples));
  std::normal_distribution<double> noise(0.0, 0.02);
  Channel channel{"velocity_1_m_s", Quantity::kVelocity, 1, {}};
  for (size_t i = 0; i < samples; ++i)
    channel.values.push_back(std::sin(0.05 * static_cast<double>(i)) + noise(random));
  return channel;
}

// One difference over the whole record after the other.
double noise_by_fourth_differences(std::vector<double> values) {
  for (int order = 0; order < 4; ++order) {
    for (size_t i = 0; i + 1 < values.size(); ++i) values[i] = values[i + 1] - values[i];
    values.pop_back();
  }
  for (double& value : values) value = std::abs(value);
  return quantile(values, 0.5) / 0.67448975 / std::sqrt(70.0);
}

// The differences are taken part by part: lengths about one part, two and some.
TEST(Statistics, NoiseIsThatOfDifferencesOverTheWholeRecord) {
  for (const size_t samples :
       {16u, 1023u, 1024u, 1025u, 1027u, 1028u, 1029u, 1030u, 1031u, 2048u, 2052u, 2053u, 20129u}) {
    const Channel channel = noisy_swing(samples);
    const Statistics statistics = statistics_of(channel);
    EXPECT_EQ(statistics.noise, noise_by_fourth_differences(channel.values)) << samples;
    EXPECT_EQ(statistics.noisy, true) << samples;
  }
}

TEST(Statistics, RepeatsCountInsideTheRangeAlone) {
  Channel channel = noisy_swing(4000);
  EXPECT_EQ(statistics_of(channel).repeats, 0.0);
  for (size_t i = 1; i < channel.values.size(); i += 2) channel.values[i] = channel.values[i - 1];
  EXPECT_NEAR(statistics_of(channel).repeats, 0.5, 0.01);
  for (double& value : channel.values) value = std::copysign(1.0, value);  // nothing is inside
  EXPECT_EQ(statistics_of(channel).repeats, 1.0);
}

}  // namespace

// How long a motion lasts, and that a fused velocity begins before it is over.
#include "hal/rig_file/recorded/moving_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/signals/leak.hpp"

namespace {

using firmware::Quantity;

std::vector<int32_t> decay(double samples_of_decay, int count) {
  std::vector<int32_t> codes;
  for (int n = 0; n < count; ++n)
    codes.push_back(100 + static_cast<int32_t>(std::lround(1e6 * std::exp(-n / samples_of_decay) * (n % 2 ? -1 : 1))));
  return codes;
}

// exp(-n / tau) of turning sign: sum of squares tau / 2, of fourth powers tau / 4: tau^2 / 4 / (tau / 4) = tau.
TEST(MovingSamples, ADecayMovesForItsTimeConstant) {
  EXPECT_NEAR(rig_file::fewest_moving_samples<int32_t>({decay(300, 5000)}), 300, 3);
  EXPECT_NEAR(rig_file::fewest_moving_samples<int32_t>({decay(300, 50000)}), 300, 3);  // rest adds nothing
}

// +-1 moves all the time; the shortest record counts.
TEST(MovingSamples, TheRecordThatMovesLeast) {
  std::vector<int32_t> square;
  for (int n = 0; n < 4000; ++n) square.push_back(n % 2 ? 1000 : -1000);
  EXPECT_NEAR(rig_file::fewest_moving_samples<int32_t>({square}), 4000, 1);
  EXPECT_NEAR(rig_file::fewest_moving_samples<int32_t>({square, decay(300, 5000)}), 300, 3);
}

TEST(MovingSamples, NothingThatMovesIsNotKnown) {
  EXPECT_EQ(rig_file::fewest_moving_samples<int32_t>({}), 0);
  EXPECT_EQ(rig_file::fewest_moving_samples<int32_t>({std::vector<int32_t>(100, 7)}), 0);
}

// Of a displacement that is a million times better than its acceleration: the longest time constant there is, 2^10 samples. A core that
// waits for two of them sees nothing of a motion of 300 samples: half of it are 150, two time constants of 2^6.
TEST(LeakShift, IsNoLongerThanHalfTheMotionLasts) {
  auto c = std::make_unique<firmware::CoreConfiguration>();
  c->dof_count = 1;
  c->sample_period_s = rig_file::to_scaled(1e-3);
  const int x = static_cast<int>(Quantity::kDisplacement), a = static_cast<int>(Quantity::kAcceleration);
  for (const int q : {x, a}) c->channels[0][q].unit_per_code = rig_file::to_scaled(1.0);
  rig_file::SignalRanges ranges;
  ranges.noise[0][x].deviation = 1.0, ranges.noise[0][a].deviation = 1e-3;
  EXPECT_EQ(rig_file::leak_shift(*c, ranges, 0), 10);
  ranges.moving_samples[0] = 300;
  EXPECT_EQ(rig_file::leak_shift(*c, ranges, 0), 6);
  ranges.moving_samples[0] = 5;
  EXPECT_EQ(rig_file::leak_shift(*c, ranges, 0), 4);  // the shortest there is
  ranges.moving_samples[0] = 1e6;
  EXPECT_EQ(rig_file::leak_shift(*c, ranges, 0), 10);
}

}  // namespace

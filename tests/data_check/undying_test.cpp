// Motion that does not die though nothing drives it.
#include "host_sim/data_check/decay/undying.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::crests;
using host_sim::data_check::find_undying;

// Down to 1, up to 5 (a crest), down to 2, up to 3 (less than twice 2), down to 1, up to 6; the last has not fallen again.
TEST(Crests, RiseToTwiceTheTroughAndFallToHalf) {
  EXPECT_EQ(crests({4, 1, 5, 2, 3, 1, 6, 2, 8}), (std::vector<double>{5, 6}));
  EXPECT_TRUE(crests({8, 4, 2, 1, 0.5}).empty());
  EXPECT_TRUE(crests({}).empty());
}

// Two masses: 1 kg on 1000 N/m to the ground, 2 N s/m, and 0.5 kg on 400 N/m, 1 N s/m, above; 20 s at 500 Hz of displacements (semi-implicit
// steps of 0.2 ms) from a pull of the first by 1 cm, or under a random force of 3 N that no channel tells of.
Record moved(bool pulled, bool shaken) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  double x[2] = {pulled ? 0.01 : 0, 0}, v[2] = {0, 0}, force = 0;
  std::vector<double> first, second;
  for (int k = 0; k < 100000; ++k) {
    if (k % 10 == 0) {
      first.push_back(x[0]), second.push_back(x[1]);
      if (shaken) force = 0.9 * force + 3 * normal(random);
    }
    const double h = 2e-4, between = 400 * (x[0] - x[1]) + v[0] - v[1];
    v[0] += h * (force - 1000 * x[0] - 2 * v[0] - between), v[1] += h * between / 0.5;
    for (int i = 0; i < 2; ++i) x[i] += h * v[i];
  }
  Record record;
  record.file = "two.csv", record.sample_period_s = 2e-3;
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, first},
                     {"displacement_2_m", Quantity::kDisplacement, 2, second}};
  return record;
}

TEST(Undying, AForceThatIsNotRecordedKeepsItUp) {
  const auto found = find_undying(moved(false, true));
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(found->kind, "work");
  EXPECT_NE(found->detail.find("what drives the rig has to be in the file"), std::string::npos);
}

TEST(Undying, ADecayOfBeatsDies) { EXPECT_FALSE(find_undying(moved(true, false))); }

TEST(Undying, ARecordedForceIsItsReason) {
  Record record = moved(false, true);
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, record.channels[0].values});
  EXPECT_FALSE(find_undying(record));
}

}  // namespace

#include "host_sim/records/median.hpp"

#include <gtest/gtest.h>

namespace {

using host_sim::median;

TEST(Median, HasAsManyBelowAsAbove) { EXPECT_EQ(median({9.0, -1.0, 4.0}), 4.0); }

TEST(Median, OfAnEvenNumberIsTheUpperOfTheTwoInTheMiddle) { EXPECT_EQ(median({3.0, 1.0, 2.0, 10.0}), 3.0); }

TEST(Median, DoesNotFollowOneThatIsFarOff) { EXPECT_EQ(median({1.0, 2.0, 1e300}), 2.0); }

TEST(Median, OfNothingIsNought) { EXPECT_EQ(median({}), 0.0); }

}  // namespace

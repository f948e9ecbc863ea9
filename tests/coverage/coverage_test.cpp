// A small fixed part of docs/coverage.md: seeds 5000 and up, none left out. Intervals of 95 % that hold in 95 % do so in at
// least 88 of 100 with a chance of 999 in 1000; 80 % of the coefficients that the record can measure within 5 % have to be VALID
// and none of them wrong.
#include <gtest/gtest.h>

#include <string>

#include "tally.hpp"

namespace {

struct Case {
  const char* condition;
  const char* sensors;
};

class Coverage : public testing::TestWithParam<Case> {};

TEST_P(Coverage, IntervalsHoldAndMostCoefficientsAreValid) {
  const coverage::Tally t = coverage::count(GetParam().condition, GetParam().sensors, 5000, 24);
  ASSERT_GE(t.coefficients, 80);
  EXPECT_GE(t.measurable_valid_percent(), 80);
  EXPECT_GE(t.valid_percent(), 60);
  EXPECT_GE(t.held_percent(), 88);
  EXPECT_EQ(t.wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(SensorSets, Coverage,
                         testing::Values(Case{"random_1pct", "xva"}, Case{"random_1pct", "xa"},
                                         Case{"random_1pct", "x"}, Case{"random_1pct", "a"}, Case{"random_5pct", "xa"},
                                         Case{"stick_slip", "xva"}, Case{"bits_12", "xva"}, Case{"ar_0p8_1pct", "x"},
                                         Case{"sine_records", "xa"}, Case{"masses_springs_unknown", "xa"},
                                         Case{"ar_0p8_5pct", "xva"}),
                         [](const auto& test) { return std::string(test.param.condition) + "_" + test.param.sensors; });

}  // namespace

// What stands off at the very ends of a record, where no neighbours are on the one side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/spikes/gaps.hpp"
#include "tests/data_check/faults.hpp"

namespace {

using faults::find;
using faults::kA1;
using faults::kX1;
using faults::with;
using host_sim::data_check::check;
using host_sim::data_check::ends_off;
using host_sim::data_check::Weight;

// 60 values between -1 and 1: the rest spans 2, so 3 and beyond stand off it; 2.9 may be a blow.
TEST(Ends, OffByMoreThanTheRestSpans) {
  std::vector<double> x(60);
  for (size_t i = 0; i < x.size(); ++i) x[i] = i % 2 == 0 ? 1 : -1;
  EXPECT_TRUE(ends_off(x).empty());
  x[0] = 2.9;
  EXPECT_TRUE(ends_off(x).empty());
  x[0] = 3.1, x[1] = 50;
  auto gaps = ends_off(x);
  ASSERT_EQ(gaps.size(), 1u);
  EXPECT_EQ(gaps[0].first, 0u);
  EXPECT_EQ(gaps[0].width, 2u);
  EXPECT_DOUBLE_EQ(gaps[0].size, 49);
  x[0] = 1, x[1] = -1, x[53] = -3.5, x[59] = 9;
  gaps = ends_off(x);
  ASSERT_EQ(gaps.size(), 2u);
  EXPECT_EQ(gaps[0].first, 53u);
  EXPECT_EQ(gaps[1].first, 59u);
  EXPECT_DOUBLE_EQ(gaps[1].size, 8);
}

// A joint that sets out: its first speeds are further off than all that follow span, and those behind lead there:
// 3 * 11 - 3 * 15.5 + 17.3 = 3.8 beside 3.
TEST(Ends, AStartFromRestIsNone) {
  std::vector<double> x(60);
  for (size_t i = 0; i < x.size(); ++i) x[i] = 19 + 2 * std::sin(0.7 * static_cast<double>(i));
  x[0] = 3, x[1] = 11, x[2] = 15.5, x[3] = 17.3;
  EXPECT_TRUE(ends_off(x).empty());
  std::reverse(x.begin(), x.end());
  EXPECT_TRUE(ends_off(x).empty());
  x.back() = -30;
  EXPECT_EQ(ends_off(x).size(), 1u);
  // faster: two are far off, of which the first is led to, 3 * 17.6 - 3 * 25.5 + 26.9 = 3.2 beside 4.1
  for (size_t i = 0; i < x.size(); ++i) x[i] = 30 + 2 * std::sin(0.7 * static_cast<double>(i));
  x[0] = 4.1, x[1] = 17.6, x[2] = 25.5, x[3] = 26.9;
  EXPECT_TRUE(ends_off(x).empty());
}

// A converter that wakes up, a last line that was cut: a displacement of 1000 m in the first or the last row.
TEST(Ends, AGlitchThereIsAFault) {
  for (const bool last : {false, true}) {
    host_sim::Record record = made::record(with("xva"));
    std::vector<double>& x = made::values(record, kX1);
    (last ? x.back() : x.front()) = 1000.0;
    const auto report = check({record}, nullptr);
    const auto* finding = find(report, "spikes", kX1);
    ASSERT_NE(finding, nullptr) << last;
    EXPECT_EQ(finding->weight, Weight::kFault) << finding->detail;
    EXPECT_NE(finding->detail.find("1 spike; the largest at"), std::string::npos) << finding->detail;
  }
}

// A blow in the first samples is one, and what rings after it.
TEST(Ends, ABlowAtTheStartIsNone) {
  const auto report = check({made::record(with("xva", made::Drive::kHammer))}, nullptr);
  EXPECT_EQ(find(report, "spikes", kX1), nullptr);
  EXPECT_EQ(find(report, "spikes", kA1), nullptr);
}

}  // namespace

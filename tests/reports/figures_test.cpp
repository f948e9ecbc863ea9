// Axes, paths and pictures, worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "host_sim/reports/figures/axis.hpp"
#include "host_sim/reports/figures/path.hpp"
#include "host_sim/reports/figures/plot.hpp"
#include "tests/reports/one_curve.hpp"

namespace {

using namespace one_curve;

std::vector<std::string> labels(const Axis& axis) {
  std::vector<std::string> out;
  for (const Tick& tick : axis.ticks) out.push_back(tick.label);
  return out;
}

// 0 to 20 in six steps: 3.3 rounds up to 5. -0.013 to 0.021 in five: 0.0068 rounds up to 0.01.
TEST(Axis, StepsAreRound) {
  EXPECT_EQ(labels(linear_axis(0.0, 20.0, 6)), (std::vector<std::string>{"0", "5", "10", "15", "20"}));
  EXPECT_EQ(labels(linear_axis(-0.013, 0.021, 5)), (std::vector<std::string>{"−0.01", "0", "0.01", "0.02"}));
}

// Ranges far from zero, tiny and huge: two ticks never read the same.
TEST(Axis, TicksDiffer) {
  for (double middle : {0.0, 4.0, -123456.0, 3e-9, 7e12})
    for (double width : {1e-6, 1e-3, 1.0, 40.0}) {
      const double half = 0.5 * width * (middle == 0.0 ? 1.0 : std::fabs(middle));
      const Axis axis = linear_axis(middle - half, middle + half, 5);
      const std::vector<std::string> all = labels(axis);
      EXPECT_GE(all.size(), 3u) << middle << " +- " << half;
      EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size()) << middle << " +- " << half;
    }
}

// From 0.5 to 2000: the decades 1, 10, 100, 1000; a tenth of the way up from 1 to 10 is 10^0.1.
TEST(Axis, DecadesOfALogarithmicScale) {
  Axis axis = decade_axis(0.5, 2000.0, 6);
  axis.at_low = 0.0, axis.at_high = std::log10(4000.0);
  ASSERT_EQ(axis.ticks.size(), 4u);
  EXPECT_EQ(axis.ticks[0].value, 1.0);
  EXPECT_NEAR(axis.place(10.0) - axis.place(1.0), 1.0, 1e-12);
  EXPECT_LE(decade_axis(1e-30, 1e30, 6).ticks.size(), 7u);
}

// (1.04, 2.06) -> (1.0, 2.1); (2.5, 1.1): step (1.5, -1.0); (2.5, 31.1): step (0, 30).
TEST(Path, LinesAreStepsOfTenths) {
  EXPECT_EQ(path_data({{1.04, 2.06}, {2.50, 1.10}, {2.50, 31.10}}), "M1 2.1l1.5-1 0 30");
}

TEST(Path, SeveralPartsAndClosing) {
  EXPECT_EQ(path_data({{0, 0}, {1, 1}, {NAN, NAN}, {5, 5}, {4.7, 5.2}}), "M0 0l1 1M5 5l-.3 .2");
  EXPECT_EQ(path_data({{5, 5}, {4.7, 5.2}}, true), "M5 5l-.3 .2z");
}

// Ten steps of 0.14: each point is rounded from where it is, so the end is at 1.4 and not at ten times 0.1.
TEST(Path, ErrorsDoNotAddUp) {
  std::vector<Point> points;
  for (int i = 0; i <= 10; ++i) points.push_back({i * 0.14, 0.0});
  EXPECT_EQ(path_data(points), "M0 0l.1 0 .2 0 .1 0 .2 0 .1 0 .1 0 .2 0 .1 0 .2 0 .1 0");
}

// The largest value is 0.002 m, so the axis is in mm.
TEST(Draw, AxesCarryLabelsAndUnits) {
  const std::string picture = draw(plot("viscous_{1}^2"), Target::kPage);
  EXPECT_EQ(count(picture, ">time (s)</text>"), 1u);
  EXPECT_EQ(count(picture, ">viscous_{1}^2 (mm)</text>"), 1u);
  EXPECT_EQ(count(picture, "var(--given)"), 1u);
  EXPECT_EQ(count(picture, "xmlns"), 0u);
}

TEST(Draw, AStandalonePictureHasItsOwnColoursTitleAndLegend) {
  const std::string picture = draw(plot("y"), Target::kStandalone);
  EXPECT_EQ(count(picture, "var(--"), 0u);
  EXPECT_GE(count(picture, "#cf5a0c"), 1u);
  EXPECT_EQ(count(picture, ">one</text>"), 1u);
  EXPECT_EQ(count(picture, ">a &lt;'title'&gt;</text>"), 1u);
  EXPECT_EQ(count(picture, "xmlns=\"http://www.w3.org/2000/svg\""), 1u);
}

// The frame of the 460 wide picture begins at 66 and ends where half of the label "2.0" (two digits of 9.3, a point of
// 4.7) and 1 more fit: 460 - 0.5 * 23.3 - 1 = 447.35. y from 0.94 to 2.06 mm (6 % of air) over 224 to 14: the middle
// point (1, 2 mm) lies at (66 + 190.7, 14 + 0.06 / 1.12 * 210 = 25.25).
TEST(Draw, PointsLieWhereTheyBelong) {
  const std::string picture = draw(plot("y"), Target::kPage);
  EXPECT_EQ(count(picture, "M66 212.8l190.7-187.5 190.7 93.7"), 1u) << picture;
}

TEST(Draw, DataWithoutFiniteNumbersStillDraws) {
  Plot empty = plot("y");
  empty.curves[0].y = {NAN, NAN, NAN};
  Plot none = plot("y");
  none.curves.clear();
  Plot log = empty;
  log.log_y = true;
  for (const Plot& each : {empty, none, log}) {
    const std::string picture = draw(each, Target::kPage);
    EXPECT_EQ(count(picture, "nan"), 0u);
    EXPECT_EQ(count(picture, "inf"), 0u);
  }
}

// Values that agree to nine digits, as the last estimates of a clean run do.
TEST(Draw, ValuesThatHardlyDifferStillDraw) {
  Plot narrow = plot("y");
  narrow.curves[0].y = {4.0, 4.000000001, 4.000000002};
  Plot constant = plot("y");
  constant.curves[0].y = {4.0, 4.0, 4.0};
  for (const Plot& each : {narrow, constant}) EXPECT_EQ(count(draw(each, Target::kPage), "nan"), 0u);
}

// Two cells known of four: the larger value at full depth in the colour of its sign.
TEST(Draw, AMapShowsSignAndSize) {
  Plot map = plot("y");
  map.curves.clear();
  map.map = {2, 2, -1.0, 1.0, -1.0, 1.0, {-2.0, NAN, NAN, 1.0}};
  const std::string picture = draw(map, Target::kPage);
  EXPECT_EQ(count(picture, "var(--term1)\" fill-opacity=\"1.00\""), 1u);
  EXPECT_EQ(count(picture, "var(--term2)\" fill-opacity=\"0.52\""), 1u);  // 0.04 + 0.96 / 2
}

}  // namespace

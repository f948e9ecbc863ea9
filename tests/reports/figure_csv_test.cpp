// The data of a picture as CSV.
#include "host_sim/reports/figures/figure_csv.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reports/one_curve.hpp"

namespace {

using namespace one_curve;

TEST(FigureCsv, ARowAPointUnderNamesWithUnits) {
  Plot picture = plot("acceleration");
  picture.y_unit = "m/s^2";
  EXPECT_EQ(figure_csv(picture), "curve,time_s,acceleration_m_s2\none,0,0.001\none,1,0.002\none,2,0.0015\n");
}

TEST(FigureCsv, ABandHasTwoEdgesAndALineBesideItOne) {
  Plot picture = plot("y");
  picture.curves.push_back({"range, 80 %", Role::kGiven, Shape::kBand, {5}, {-1}, {2}});
  EXPECT_EQ(figure_csv(picture),
            "curve,time_s,y_m,upper\none,0,0.001,\none,1,0.002,\none,2,0.0015,\n\"range, 80 %\",5,-1,2\n");
}

TEST(FigureCsv, WhatThePictureLeavesOutIsLeftOut) {
  Plot picture = plot("y");
  picture.curves[0].label.clear();
  picture.curves[0].y[1] = NAN;
  EXPECT_EQ(figure_csv(picture), "curve,time_s,y_m\ncurve_1,0,0.001\ncurve_1,2,0.0015\n");
}

// Two by two cells of [0, 4] times [0, 2]: middles at 1 and 3, 0.5 and 1.5; the last is not known.
TEST(FigureCsv, AMapGivesTheMiddlesOfItsCells) {
  Plot picture = plot("rate");
  picture.map = {2, 2, 0, 4, 0, 2, {10, 11, 12, NAN}, 0};
  EXPECT_EQ(figure_csv(picture), "time_s,rate_m,value\n1,0.5,10\n3,0.5,11\n1,1.5,12\n");
}

TEST(FigureCsv, FilesAreNamedByNumberAndTitle) {
  Plot picture = plot("y");
  picture.title = "DOF 1, displacement";
  EXPECT_EQ(figure_file_name(7, picture), "07_dof_1_displacement.csv");
  picture.title = "<&>";
  EXPECT_EQ(figure_file_name(123, picture), "123_figure.csv");
  for (const char* name : {"07_dof_1_displacement.csv", "123_figure.csv"}) EXPECT_TRUE(is_figure_file_name(name));
  for (const char* name : {"notes.csv", "7_a.csv", "07_a.txt", "07_a b.csv", "07", "2026.csv"})
    EXPECT_FALSE(is_figure_file_name(name)) << name;
}

}  // namespace

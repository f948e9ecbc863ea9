// Numbers and units as printed: worked out by hand.
#include "host_sim/reports/figures/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/reports/page/shared_parts.hpp"

namespace {

using namespace host_sim::reports;

TEST(Numbers, KeepTheDigitsAskedFor) {
  EXPECT_EQ(number_html(20.0, 4), "20.00");
  EXPECT_EQ(number_html(-0.5, 3), "−0.500");
  EXPECT_EQ(number_html(1234.0, 4), "1234");
  EXPECT_EQ(number_html(0.0, 4), "0");
  EXPECT_EQ(number_html(3.1249e7, 3), "3.12 × 10<sup>7</sup>");
  EXPECT_EQ(number_html(-2e-9, 2), "−2.0 × 10<sup>−9</sup>");
  EXPECT_EQ(number_html(NAN, 4), "–");
  EXPECT_EQ(number_text(31249000.0, 3), "3.12e+07");
}

TEST(Numbers, SharesAreReadInPercent) {
  EXPECT_EQ(percent_text(4.13), "4.1");
  EXPECT_EQ(percent_text(68.4), "68");
  EXPECT_EQ(percent_text(99.7), "100");
  EXPECT_EQ(percent_text(412.3), "412");
  EXPECT_EQ(percent_text(NAN), "–");
}

// The diagnosis says no more than that an error is 1000 % or larger.
TEST(Numbers, AnErrorOfAThousandPercentIsNoNumber) {
  EXPECT_EQ(missed_text(9.294), "9.29");
  EXPECT_EQ(missed_text(1000), ">1000");
  EXPECT_EQ(missed_html(1000), "&gt;1000");
}

TEST(Numbers, UnitsAreSetAsPrinted) {
  EXPECT_EQ(unit_text("N s/m"), "N·s/m");
  EXPECT_EQ(unit_text("N/m^3"), "N/m³");
  EXPECT_EQ(unit_text("Hz"), "Hz");
}

// 0.0021 m is 2.1 mm; the prefix must keep value * factor between 1 and 1000.
TEST(Numbers, PrefixBringsTheLargestValueBetweenOneAndAThousand) {
  EXPECT_EQ(best_prefix(0.0021, "m").symbol, "m");
  EXPECT_DOUBLE_EQ(best_prefix(0.0021, "m").factor, 1e3);
  EXPECT_EQ(best_prefix(0.0021e-3, "m/s").symbol, "µ");
  EXPECT_EQ(best_prefix(45e3, "N").symbol, "k");
  EXPECT_EQ(best_prefix(12.0, "m/s^2").symbol, "");
  EXPECT_EQ(best_prefix(0.0, "m").symbol, "");
}

TEST(Numbers, NoPrefixForUnitsThatTakeNone) {
  for (const char* unit : {"", "s", "Hz", "%", "kg", "m^2", "(m)^2/Hz"}) {
    EXPECT_EQ(best_prefix(1e-5, unit).symbol, "") << unit;
    EXPECT_EQ(best_prefix(1e-5, unit).factor, 1.0) << unit;
  }
}

// 20.0123 in 19.9 .. 20.1: the width 0.2 makes the second decimal the last one that says something: 20.01.
TEST(Numbers, AnIntervalDecidesTheDigits) {
  EXPECT_EQ(interval_html({20.0123, 19.9, 20.1}), "20.012 <span class=\"dim\">(19.900 … 20.100)</span>");
  EXPECT_EQ(digits_for({1.0, 0.5, 1.5}), 3);
  EXPECT_EQ(digits_for({1.0, 1.0 - 1e-9, 1.0 + 1e-9}), 7);
  EXPECT_EQ(interval_html({NAN, NAN, NAN}), "<span class=\"dim\">–</span>");
}

}  // namespace

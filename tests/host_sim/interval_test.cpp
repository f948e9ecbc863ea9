// What the table of estimates says of an interval that is not known, of results made by hand.
#include <gtest/gtest.h>

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/programs/results/result_table.hpp"

namespace {

using firmware::EstimateStatus;

// The words of the row of a stiffness of 32.68221 N/m.
std::vector<std::string> row(EstimateStatus status, double half, double value = 32.68221) {
  host_sim::EstimateResult result;
  host_sim::ParameterResult parameter;
  parameter.info.name = "stiffness[1-0]", parameter.info.unit = "N/m";
  parameter.value = value, parameter.std = half / 1.96, parameter.status = status;
  parameter.ci95_low = parameter.value - half, parameter.ci95_high = parameter.value + half;
  result.parameters = {parameter};
  std::istringstream table(host_sim::format_table(result, false, 0));
  std::string line;
  std::getline(table, line), std::getline(table, line);
  std::istringstream words(line);
  return {std::istream_iterator<std::string>(words), {}};
}

using Words = std::vector<std::string>;

TEST(Interval, OfNoWidthIsADashWhereTheNumberIsNotKnown) {
  EXPECT_EQ(row(EstimateStatus::kIllConditioned, 0),
            (Words{"stiffness[1-0]", "32.7", "-", "-", "N/m", "ILL_CONDITIONED"}));
  EXPECT_EQ(row(EstimateStatus::kNoExcitation, 0), (Words{"stiffness[1-0]", "32.7", "-", "-", "N/m", "NO_EXCITATION"}));
}

// A nought that nothing was fitted to is no number either.
TEST(Interval, ANumberThatWasNeverFittedIsADash) {
  for (const EstimateStatus status : {EstimateStatus::kNoExcitation, EstimateStatus::kStale})
    EXPECT_EQ(row(status, 0, 0)[1], "-");
}

// 32.7 +- 654 (20 times) is the last that says how large it may be.
TEST(Interval, ANumberWhoseMagnitudeIsNotKnownIsADash) {
  EXPECT_EQ(row(EstimateStatus::kIllConditioned, 660),
            (Words{"stiffness[1-0]", "-", "-", "-", "N/m", "ILL_CONDITIONED"}));
  EXPECT_NE(row(EstimateStatus::kIllConditioned, 640)[1], "-");
  EXPECT_NE(row(EstimateStatus::kValid, 660)[1], "-");
}

TEST(Interval, IsToldWhereItIsKnown) {
  EXPECT_EQ(row(EstimateStatus::kIllConditioned, 20),
            (Words{"stiffness[1-0]", "32.7", "12.7", "52.7", "N/m", "ILL_CONDITIONED"}));
  EXPECT_EQ(row(EstimateStatus::kValid, 0),
            (Words{"stiffness[1-0]", "32.68221", "32.68221", "32.68221", "N/m", "VALID"}));
}

// Whether the table of one damper of this value +- 1 has these words.
bool says(double value, EstimateStatus status, const std::string& words) {
  host_sim::EstimateResult result;
  host_sim::ParameterResult parameter;
  parameter.info.name = "viscous[1-0]", parameter.info.unit = "N s/m";
  parameter.value = value, parameter.std = 0.5, parameter.status = status;
  parameter.ci95_low = value - 1.0, parameter.ci95_high = value + 1.0;
  result.parameters = {parameter}, result.warrant.tested = true;
  return host_sim::format_table(result, false, 0).find(words) != std::string::npos;
}

TEST(Contradiction, ANumberThatCannotBeIsNotNothing) {
  EXPECT_TRUE(says(-3.0, EstimateStatus::kModelSuspect, "viscous[1-0] is below nought, which cannot be"));
  EXPECT_FALSE(says(-3.0, EstimateStatus::kModelSuspect, "finds nothing"));
  EXPECT_TRUE(says(3.0, EstimateStatus::kValid, "finds nothing"));
}

}  // namespace

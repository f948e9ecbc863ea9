// Which parameters rows can tell apart: rows of whole numbers, worked out by hand.
#include "firmware/identification/fit/identifiability.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace {

using firmware::Scaled;

firmware::Identifiability judged(const std::vector<std::vector<int>>& rows) {
  const auto unknowns = static_cast<int>(rows[0].size());
  const auto equations = std::make_unique<firmware::NormalEquations>();
  equations->clear(unknowns);
  for (const std::vector<int>& values : rows) {
    firmware::Row row;
    firmware::clear_row(unknowns, row);
    for (int k = 0; k < unknowns; ++k) row.column[k] = Scaled::from_int(values[static_cast<size_t>(k)]);
    equations->add(row);
  }
  equations->factorise();
  Scaled parameters[firmware::kMaxUnknowns];
  for (int k = 0; k < unknowns; ++k) parameters[k] = Scaled::from_int(1);
  firmware::Identifiability result;
  firmware::judge_identifiability(*equations, parameters, result);
  return result;
}

bool told_apart(const firmware::Identifiability& result, int k) { return !result.inflation[k].is_zero(); }

}  // namespace

// N = [[2, 1], [1, 1]], N^-1 = [[1, -1], [-1, 2]]; the columns' norms are sqrt 2 and 1: inflations sqrt 1 * sqrt 2 and sqrt 2 * 1.
TEST(Identifiability, InflationOfTwoColumns) {
  const firmware::Identifiability result = judged({{1, 0}, {1, 1}});
  for (int k = 0; k < 2; ++k)
    EXPECT_LT(abs(result.inflation[k] * result.inflation[k] - Scaled::from_int(2)), Scaled::from_int(1, -30)) << k;
}

// The second column is twice the first: it is left out, and the first would take up whatever its parameter is. The third has a row of
// its own.
TEST(Identifiability, WhatTakesUpAColumnThatIsLeftOutIsNotToldApart) {
  const firmware::Identifiability result = judged({{1, 2, 0}, {2, 4, 0}, {0, 0, 3}});
  EXPECT_FALSE(told_apart(result, 0));
  EXPECT_FALSE(told_apart(result, 1));
  EXPECT_TRUE(told_apart(result, 2));
}

// The fourth is the second and the third together, and no part of the first, although all rows have the first.
TEST(Identifiability, WhatIsNoPartOfItStands) {
  const firmware::Identifiability result =
      judged({{1, 1, 0, 1}, {1, 0, 1, 1}, {1, 2, 3, 5}, {1, 4, 1, 5}, {2, 0, 0, 0}});
  EXPECT_TRUE(told_apart(result, 0));
  for (int k = 1; k < 4; ++k) EXPECT_FALSE(told_apart(result, k)) << k;
}

// A column of noughts takes nothing up: its parameter stands in no row.
TEST(Identifiability, AColumnOfNoughtsEntanglesNothing) {
  const firmware::Identifiability result = judged({{1, 0}, {2, 0}});
  EXPECT_TRUE(told_apart(result, 0));
  EXPECT_FALSE(told_apart(result, 1));
}

// Paths made shorter: worked out by hand.
#include "host_sim/reports/compact_path.hpp"

#include <gtest/gtest.h>

namespace {

using namespace host_sim::reports;

// (1.04, 2.06) -> (1.0, 2.1); (2.5, 1.1): step (1.5, -1.0); (2.5, 31.1): step (0, 30).
TEST(CompactPath, LinesBecomeStepsOfTenths) {
  EXPECT_EQ(compact_path("M1.04,2.06 L2.50,1.10\n\t\tL2.50,31.10  "), "M1 2.1l1.5-1 0 30");
}

TEST(CompactPath, SeveralPartsAndClosing) {
  EXPECT_EQ(compact_path("M0.00,0.00 L1.00,1.00 M5.00,5.00 L4.70,5.20 Z"), "M0 0l1 1M5 5l-.3 .2z");
}

// Ten steps of 0.14: each point is rounded from where it is, so the end is at 1.4 and not at ten times 0.1.
TEST(CompactPath, ErrorsDoNotAddUp) {
  std::string path = "M0.00,0.00";
  for (int i = 1; i <= 10; ++i) path += " L" + std::to_string(i * 0.14) + ",0.00";
  EXPECT_EQ(compact_path(path), "M0 0l.1 0 .2 0 .1 0 .2 0 .1 0 .1 0 .2 0 .1 0 .2 0 .1 0");
}

TEST(CompactPath, OthersStayAsTheyAre) {
  EXPECT_EQ(compact_path("M1,1 h2 v3"), "M1,1 h2 v3");
  EXPECT_EQ(compact_path(""), "");
  EXPECT_EQ(with_compact_paths("<path stroke='x' d='M1.00,1.00 L2.00,2.00'/><path d='q'/>"),
            "<path stroke='x' d='M1 1l1 1'/><path d='q'/>");
}

}  // namespace

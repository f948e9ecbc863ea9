// A force along the motion that does not vary where nothing was fitted, as of a shaft at constant speed.
#include <gtest/gtest.h>

#include "host_sim/diagnosis/unseen/error_sums.hpp"

namespace diagnosis::runs {
namespace {

// 2 N m all along, of which a model says 1.8 N m.
DofErrors a_tenth_missed(double varies_by_N_m) {
  Vec measured = Vec::Constant(100, 2.0);
  for (Index i = 0; i < measured.size(); ++i) measured[i] += i % 2 ? varies_by_N_m : -varies_by_N_m;
  DofErrors of;
  of.x.add(measured.array() - 0.2, measured);
  of.force = measured.squaredNorm();
  of.v = of.a = of.x;
  for (ErrorSums* sums : {&of.x, &of.v, &of.a}) sums->end_record();
  return of;
}

// About its mean there is nothing to miss: 0 %, of any model.
TEST(SteadyForce, IsMissedByAShareOfItself) {
  DofErrors of = a_tenth_missed(0);
  EXPECT_EQ(score_of({of}, true).nrmse_percent[0], 0);
  count_steady_force(of);
  EXPECT_NEAR(score_of({of}, true).nrmse_percent[0], 10, 1e-9);
}

TEST(SteadyForce, OneThatVariesIsMissedByAShareOfThat) {
  DofErrors of = a_tenth_missed(1);
  count_steady_force(of);
  EXPECT_NEAR(score_of({of}, true).nrmse_percent[0], 20, 1e-9);
}

}  // namespace
}  // namespace diagnosis::runs

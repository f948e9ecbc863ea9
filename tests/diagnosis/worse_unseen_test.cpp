// A cause with which nobody could predict is taken back.
#include "host_sim/diagnosis/doubts/worse_unseen.hpp"

#include <gtest/gtest.h>

namespace {

using namespace diagnosis;

// A mode beside a coasting car; with it the run of unseen data misses `extended` % where the rig as given misses 10.
Diagnosis named(double extended) {
  Diagnosis d;
  d.verdict = Verdict::kPartly;
  Cause cause;
  cause.effect = "unmodelled_resonance", cause.where = "dof 1";
  d.causes = {cause};
  d.baseline.parameters = {{"viscous[1-0]", 18.8, "N s/m", 2.4, true}};
  d.extended.parameters = {{"viscous[1-0]", 183, "N s/m", 540, true}};
  d.baseline.holdout_nrmse_percent = {10}, d.extended.holdout_nrmse_percent = {extended};
  d.gain = {10 / extended}, d.remainder_percent = {100 * extended / 10};
  return d;
}

TEST(WorseUnseen, IsTakenBackAndTheRigStands) {
  Diagnosis d = named(16);
  runs::reject_what_simulates_worse({}, d);
  EXPECT_EQ(d.verdict, Verdict::kUnknown);
  EXPECT_TRUE(d.causes.empty());
  ASSERT_EQ(d.rejected.size(), 1u);
  EXPECT_EQ(d.rejected[0].effect, "unmodelled_resonance");
  EXPECT_EQ(d.extended.parameters.at(0).value, 18.8);
  EXPECT_EQ(d.gain.at(0), 1);
}

TEST(WorseUnseen, ALittleWorseIsChance) {
  for (const double extended : {2.0, 10.0, 14.0}) {
    Diagnosis d = named(extended);
    runs::reject_what_simulates_worse({}, d);
    EXPECT_EQ(d.verdict, Verdict::kPartly) << extended;
    EXPECT_EQ(d.causes.size(), 1u) << extended;
  }
}

// What was taken out of the record before the rig was judged is no part of either simulation.
TEST(WorseUnseen, AChannelsFaultStays) {
  Diagnosis d = named(30);
  d.causes[0].taken_out = true;
  runs::reject_what_simulates_worse({}, d);
  EXPECT_EQ(d.causes.size(), 1u);
}

}  // namespace

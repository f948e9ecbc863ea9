// What a late channel is told to need, of one DOF's estimates made by hand.
#include "host_sim/programs/results/advice.hpp"

#include <gtest/gtest.h>

#include "hal/rig_file/scaled_double.hpp"

namespace {

using host_sim::EstimateResult;
using host_sim::Quantity;

// The displacement is 400 +- 2 us late (two deviations of 1 us); there are these channels.
EstimateResult late_displacement(const std::vector<host_sim::Channel>& channels) {
  rig_file::RigModel model;
  model.dofs.resize(1);
  firmware::Estimates estimates;
  estimates.advice = firmware::Advice::kCompensateSkew;
  estimates.advice_index = 0;
  firmware::SkewEstimate& skew = estimates.displacement_skew[0];
  skew.measured = skew.significant = true;
  skew.late_s = rig_file::to_scaled(400e-6);
  skew.std_s = rig_file::to_scaled(1e-6);
  host_sim::Record record;
  record.channels = channels;
  return host_sim::result_of(model, estimates, {record});
}

const host_sim::Channel kDisplacement{"displacement_1_m", Quantity::kDisplacement, 1, {0.0, 1.0}};
const host_sim::Channel kVelocity{"velocity_1_m_s", Quantity::kVelocity, 1, {0.0, 1.0}};

}  // namespace

namespace {

// Of one friction, 0.01 N with this interval.
std::string told_of_friction(double low_N, double high_N, firmware::EstimateStatus status) {
  rig_file::RigModel model;
  model.dofs.resize(1);
  rig_file::Link link;
  link.a = 1;
  link.coulomb_N.estimate = true;
  model.links.push_back(link);
  firmware::Estimates estimates;
  estimates.unknown_count = 1;
  estimates.advice = firmware::Advice::kRaiseLevel;
  estimates.advice_index = 0;
  firmware::ParameterEstimate& friction = estimates.parameters[0];
  friction.value = rig_file::to_scaled(0.01), friction.status = status;
  friction.ci95_low = rig_file::to_scaled(low_N), friction.ci95_high = rig_file::to_scaled(high_N);
  return host_sim::result_of(model, estimates, {}).advice;
}

}  // namespace

// A link may slide with all its might and have hardly any friction: 0.01 +- 0.02 N may be none, 0.01 +- 0.006 N is known to 60 %.
TEST(WideInterval, ASmallNumberIsNoWantOfMotion) {
  using firmware::EstimateStatus;
  EXPECT_EQ(
      told_of_friction(-0.01, 0.03, EstimateStatus::kValid),
      "coulomb[1-0] may be nought: its 95 % interval holds it; where that matters, raise the level or drive another "
      "DOF");
  EXPECT_EQ(told_of_friction(0.004, 0.016, EstimateStatus::kValid),
            "coulomb[1-0] is known to 60 % only; where that matters, raise the level or drive another DOF");
  EXPECT_EQ(told_of_friction(-0.01, 0.03, EstimateStatus::kNoExcitation),
            "raise the level, or drive another DOF: what coulomb[1-0] acts on hardly moves, or noise hides which way");
}

TEST(LateChannel, TheRigFileTakesItsDelayAway) {
  const EstimateResult result = late_displacement({kDisplacement, kVelocity});
  EXPECT_EQ(result.advice, "give the late channel of DOF 1 its delay_us in the rig file");
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(result.notes[0],
            "displacement_1_m is 400 us late against the velocity (+- 2): a [[channel]] with delay_us = 400 in the rig "
            "file takes it away");
}

// The rig file has no channel for what is made from the velocity: a delay_us there would be refused or without effect.
TEST(LateChannel, WhatIsDerivedHasNoDelayToGive) {
  const EstimateResult result = late_displacement({kVelocity});
  EXPECT_EQ(result.advice, "measure displacement_1_m as well");
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_EQ(result.notes[0],
            "displacement_1_m is 400 us late against the velocity (+- 2): it is made from other channels; measure it "
            "as well");
}

// 0.2 s of a swing, all of it measured: what lacks is time.
TEST(Unanswered, AShortRecordIsSaidToBeShort) {
  EstimateResult result;
  result.condition_number = 7.0, result.has_rates = true, result.swings = 1;
  result.parameters.resize(1);
  result.parameters[0].status = firmware::EstimateStatus::kIllConditioned;
  const std::string text = host_sim::unanswered(result);
  EXPECT_NE(text.find("the record is short (1 swing of"), std::string::npos) << text;
  EXPECT_EQ(text.find("velocity or acceleration as well"), std::string::npos) << text;
  result.has_rates = false, result.swings = 100;
  const std::string other = host_sim::unanswered(result);
  EXPECT_EQ(other.find("short"), std::string::npos) << other;
  EXPECT_NE(other.find("velocity or acceleration as well"), std::string::npos) << other;
}

// A car that rolls out: what no spring holds does not swing, however long the record is.
TEST(Unanswered, WhatNoSpringHoldsIsAskedForSpeeds) {
  EstimateResult result;
  result.condition_number = 7.0, result.has_rates = true, result.swings = 0, result.held = false;
  result.parameters.resize(1);
  result.parameters[0].status = firmware::EstimateStatus::kIllConditioned;
  const std::string text = host_sim::unanswered(result);
  EXPECT_NE(text.find("hidden by noise"), std::string::npos) << text;
  EXPECT_NE(text.find("record several runs, each over all speeds from the highest down to rest"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("cycles"), std::string::npos) << text;
  EXPECT_EQ(text.find("swing"), std::string::npos) << text;
}

// Condition 7: the columns differ well, so something scatters. Beside a force that the rig file lacks that is the force, not noise;
// beside a channel's delay that has been taken out and explains everything, it is noise again.
TEST(Unanswered, ScatterIsNoiseOnlyWhereNothingIsSuspected) {
  EstimateResult result;
  result.condition_number = 7.0;
  result.parameters.resize(1);
  result.parameters[0].info.name = "viscous[1-0]";
  result.parameters[0].status = firmware::EstimateStatus::kIllConditioned;
  EXPECT_NE(host_sim::unanswered(result).find("hidden by noise"), std::string::npos);
  result.warrant.named.effect = "force_offset";
  EXPECT_NE(host_sim::unanswered(result).find("what the rig file lacks"), std::string::npos);
  EXPECT_EQ(host_sim::unanswered(result).find("noise"), std::string::npos);
  result.warrant.explained = true;
  EXPECT_NE(host_sim::unanswered(result).find("hidden by noise"), std::string::npos);
}

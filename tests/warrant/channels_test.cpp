// Channels of another gain, late ones, and those of a moving base.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/scaled_double.hpp"
#include "verdict_counts.hpp"

namespace {

using firmware::EstimateStatus;
using hidden_rig::Settings;
using rig_file::to_double;
using warrant_test::CoreRun;
using warrant_test::run_core;
using warrant_test::valid_and_wrong;

// With mass and springs unknown all coefficients take up a gain of the force, and what they leave of the force is the residual
// itself: a gain explains it always, and is no candidate.
TEST(Warrant, AForcesGainIsNoCandidateWhereNothingIsKnown) {
  Settings settings;
  settings.masses = 1;
  hidden_rig::Draw draw = hidden_rig::make_draw(9050, settings);
  const auto gains = [&draw] {
    static firmware::ProbePlan plan;
    firmware::make_probe_plan(run_core(draw).configuration, firmware::kWarrantNumbers, plan);
    return std::count_if(plan.probe, plan.probe + plan.probe_count,
                         [](const firmware::Probe& p) { return p.form == firmware::Form::kForce; });
  };
  EXPECT_EQ(gains(), 1);
  for (rig_file::Dof& dof : draw.rig.dofs) dof.mass_kg.estimate = true;
  EXPECT_EQ(gains(), 1);  // the springs are known
  for (rig_file::Link& link : draw.rig.links) link.stiffness_N_m.estimate = true;
  EXPECT_EQ(gains(), 0);
}

// A gain of 1.05 in one of a DOF's motion channels: a slope of 1.05 where 1 belongs. With one damper and one mass the equations alone
// say nothing: the damper's coefficient is c / 1.05. Turned over and in another unit: gains of -1, 9.81 and 1000.
TEST(Warrant, AMotionChannelOfAnotherGainIsNamed) {
  for (const host_sim::Quantity quantity :
       {host_sim::Quantity::kVelocity, host_sim::Quantity::kDisplacement, host_sim::Quantity::kAcceleration})
    for (const double gain : {1.05, -1.0, 9.80665, 1000.0}) {
      const int masses = gain == 1.05 ? 2 : 1;
      Settings settings;
      settings.masses = masses;
      hidden_rig::Draw draw = hidden_rig::make_draw(9200, settings);
      for (host_sim::Channel& channel : draw.records.front().channels)
        if (channel.dof == 1 && channel.quantity == quantity)
          for (double& value : channel.values) value *= gain;
      const CoreRun run = run_core(draw);
      const firmware::Finding& named = run.core->estimates().warrant.named;
      const firmware::Cause slip = gain < 0 ? firmware::Cause::kPolarity : firmware::Cause::kUnit;
      EXPECT_EQ(named.cause, gain == 1.05 ? firmware::cause_of(firmware::EffectKind::kSensorGain) : slip) << gain;
      EXPECT_EQ(named.node_a, 0);
      EXPECT_EQ(static_cast<int>(named.quantity), static_cast<int>(quantity)) << gain;
      EXPECT_NEAR(to_double(named.size), gain - 1, 0.003 + 0.01 * std::abs(gain - 1)) << gain;
      EXPECT_EQ(valid_and_wrong(draw, run.core->estimates()), 0);
    }
}

// One sample late: a velocity makes its neighbours look early, both.
TEST(Warrant, ALateChannelIsNamed) {
  for (const host_sim::Quantity quantity :
       {host_sim::Quantity::kVelocity, host_sim::Quantity::kDisplacement, host_sim::Quantity::kAcceleration}) {
    Settings settings;
    settings.masses = 2;
    hidden_rig::Draw draw = hidden_rig::make_draw(9210, settings);
    for (host_sim::Channel& channel : draw.records.front().channels)
      if (channel.dof == 2 && channel.quantity == quantity)
        std::copy_backward(channel.values.begin(), channel.values.end() - 1, channel.values.end());
    const CoreRun run = run_core(draw);
    const firmware::Finding& named = run.core->estimates().warrant.named;
    EXPECT_EQ(named.cause, firmware::cause_of(firmware::EffectKind::kSensorDelay));
    EXPECT_EQ(named.node_a, 1);
    EXPECT_EQ(static_cast<int>(named.quantity), static_cast<int>(quantity));
    EXPECT_NEAR(to_double(named.size), 1e-3, 1e-4);
  }
}

// A velocity that is made of displacement and acceleration lies between them: a gain of one turns it against both alike, a delay against
// one as late and against the other as early. Springs and mass say whose it is; the mass also how large, within a third: the velocity is
// off too. Turned over it is none, and that is told in most draws, not in all.
TEST(Warrant, AGainBesideAFusedVelocityIsNoDelay) {
  const firmware::Cause a_gain = firmware::cause_of(firmware::EffectKind::kSensorGain);
  for (const host_sim::Quantity quantity : {host_sim::Quantity::kDisplacement, host_sim::Quantity::kAcceleration})
    for (const double gain : {1.05, 0.95, 9.80665})
      for (const int dof : {1, 2}) {
        Settings settings;
        settings.masses = 2;
        settings.sensors = "xa";
        hidden_rig::Draw draw = hidden_rig::make_draw(9220, settings);
        for (host_sim::Channel& channel : draw.records.front().channels)
          if (channel.dof == dof && channel.quantity == quantity)
            for (double& value : channel.values) value *= gain;
        const CoreRun run = run_core(draw);
        const firmware::Finding& named = run.core->estimates().warrant.named;
        if (gain < 2) {
          EXPECT_EQ(named.cause, a_gain) << gain << " " << dof;
        } else {
          EXPECT_TRUE(named.cause == firmware::Cause::kUnit || named.cause == a_gain) << dof;
        }
        EXPECT_EQ(named.node_a, dof - 1);
        EXPECT_EQ(static_cast<int>(named.quantity), static_cast<int>(quantity)) << gain << " " << dof;
        if (quantity == host_sim::Quantity::kAcceleration) {
          EXPECT_EQ(named.cause, gain < 2 ? a_gain : firmware::Cause::kUnit) << gain << " " << dof;
          EXPECT_NEAR(to_double(named.size), gain - 1, 0.34 * std::abs(gain - 1)) << gain << " " << dof;
        }
        EXPECT_EQ(valid_and_wrong(draw, run.core->estimates()), 0);
      }
}

TEST(Warrant, WhichOfTwoChannelsIsLateItsEquationSays) {
  for (const host_sim::Quantity quantity : {host_sim::Quantity::kDisplacement, host_sim::Quantity::kAcceleration}) {
    Settings settings;
    settings.masses = 2;
    settings.sensors = "xa";
    hidden_rig::Draw draw = hidden_rig::make_draw(9230, settings);
    for (host_sim::Channel& channel : draw.records.front().channels)
      if (channel.dof == 2 && channel.quantity == quantity)
        std::copy_backward(channel.values.begin(), channel.values.end() - 1, channel.values.end());
    const CoreRun run = run_core(draw);
    const firmware::Finding& named = run.core->estimates().warrant.named;
    EXPECT_EQ(named.cause, firmware::cause_of(firmware::EffectKind::kSensorDelay));
    EXPECT_EQ(named.node_a, 1);
    EXPECT_EQ(static_cast<int>(named.quantity), static_cast<int>(quantity));
    EXPECT_NEAR(to_double(named.size), 1e-3, 4e-4);
  }
}

// Where masses and springs are estimated too they pass on to every equation what a late channel takes from one.
TEST(Warrant, ALateChannelLeavesNothingValidWhereMassesAreUnknown) {
  int skewed = 0;
  for (uint64_t seed = 8600; seed < 8606; ++seed) {
    Settings settings;
    settings.hidden = "sensor_delay";
    settings.condition = "masses_springs_unknown";
    settings.masses = 3;
    const CoreRun run = run_core(hidden_rig::make_draw(seed, settings));
    const firmware::Estimates& estimates = run.core->estimates();
    const auto count = [&](EstimateStatus status) {
      return std::count_if(estimates.parameters, estimates.parameters + estimates.unknown_count,
                           [&](const firmware::ParameterEstimate& p) { return p.status == status; });
    };
    if (count(EstimateStatus::kSkewed) == 0) continue;
    ++skewed;
    EXPECT_EQ(count(EstimateStatus::kValid), 0) << seed;
  }
  EXPECT_GE(skewed, 3);
}

// Every channel of the base two samples late, 2 ms: the channels agree with each other, and not with the rig.
TEST(Warrant, ABaseThatIsReadLateIsNamed) {
  Settings settings;
  settings.condition = "moving_base";
  settings.masses = 2;
  hidden_rig::Draw draw = hidden_rig::make_draw(9300, settings);
  for (host_sim::Channel& channel : draw.records.front().channels)
    if (channel.dof == rig_file::kBase)
      std::copy_backward(channel.values.begin(), channel.values.end() - 2, channel.values.end());
  const CoreRun run = run_core(draw);
  const firmware::Finding& named = run.core->estimates().warrant.named;
  EXPECT_EQ(named.cause, firmware::cause_of(firmware::EffectKind::kSensorDelay));
  EXPECT_EQ(named.node_a, firmware::kBaseNode);
  EXPECT_NEAR(to_double(named.size), 2e-3, 2e-4);
  EXPECT_EQ(valid_and_wrong(draw, run.core->estimates()), 0);
}

}  // namespace

// What the board says of rigs whose model lacks something, and of rigs whose model is right: conditions, not seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core_run.hpp"
#include "hal/rig_file/scaled_double.hpp"

namespace {

using firmware::EstimateStatus;
using hidden_rig::Settings;
using rig_file::to_double;
using warrant_test::CoreRun;
using warrant_test::run_core;

// VALID, over 5 % and over 4 quoted deviations from the truth.
int valid_and_wrong(const hidden_rig::Draw& draw, const firmware::Estimates& estimates) {
  int wrong = 0;
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const firmware::ParameterEstimate& p = estimates.parameters[k];
    const double truth = draw.coefficients[static_cast<size_t>(k)].value, off = std::abs(to_double(p.value) - truth);
    wrong += p.status == EstimateStatus::kValid && off > 0.05 * std::abs(truth) && off > 4.0 * to_double(p.std);
  }
  return wrong;
}

bool suspect(const firmware::Estimates& estimates) {
  for (int k = 0; k < estimates.unknown_count; ++k)
    if (estimates.parameters[k].status == EstimateStatus::kModelSuspect) return true;
  return false;
}

// The seventeen kinds in which a coefficient used to go out VALID and 5 to 550 % off. Where signals are derived the noise of
// one sample is that of its neighbours too, and every signal passes a filter.
const char* const kHidden[] = {"quadratic_damping",
                               "displacement_dependent_damping",
                               "backlash",
                               "missing_viscous",
                               "missing_coulomb",
                               "stribeck",
                               "drifting_viscous",
                               "sensor_delay",
                               "sensor_gain",
                               "cubic_damping",
                               "cubic_stiffness",
                               "asymmetric_viscous",
                               "force_delay",
                               "end_stop",
                               "mass_error",
                               "stiffness_error",
                               "unmodelled_resonance"};

struct Measured {
  const char* sensors;
  const char* condition;
};
class HiddenEffects : public testing::TestWithParam<Measured> {};

TEST_P(HiddenEffects, NeverLetAWrongNumberOutAsValid) {
  int records = 0, withdrawn = 0, wrong = 0;
  for (const char* hidden : kHidden) {
    Settings settings;
    settings.hidden = hidden;
    settings.condition = GetParam().condition;
    settings.sensors = GetParam().sensors;
    settings.masses = std::string(hidden) == "missing_viscous" ? 3 : 1 + records % 3;
    const hidden_rig::Draw draw = hidden_rig::make_draw(static_cast<uint64_t>(7000 + records), settings);
    const CoreRun run = run_core(draw);
    ++records;
    withdrawn += suspect(run.core->estimates());
    const int here = valid_and_wrong(draw, run.core->estimates());
    wrong += here > 0;
    if (here > 0) std::printf("VALID and wrong: %s, seed %d\n", hidden, 6999 + records);
  }
  // Accelerometers alone see little of what friction does at small rates: a weak Stribeck force passes for Coulomb's.
  EXPECT_LE(wrong, std::string(GetParam().sensors) == "a" ? 1 : 0);
  EXPECT_GT(withdrawn, records / 2);  // not by keeping quiet: strengths are 0.05 to 0.6 of the damping force
}

INSTANTIATE_TEST_SUITE_P(Warrant, HiddenEffects,
                         testing::Values(Measured{"xva", "random_1pct"}, Measured{"xva", "random_5pct"},
                                         Measured{"xa", "random_1pct"}, Measured{"x", "random_1pct"},
                                         Measured{"a", "random_1pct"}),
                         [](const auto& test) { return std::string(test.param.sensors) + "_" + test.param.condition; });

// A load cell whose drive is off says zero in every sample: no noise that nobody knows, and no force that filters round up to.
TEST(Warrant, DecaysBesideADriveThatIsOffAreTested) {
  int withdrawn = 0;
  for (const char* sensors : {"xa", "x"})
    for (const char* hidden : {"none", "missing_coulomb"})
      for (uint64_t seed = 8700; seed < 8704; ++seed) {
        Settings settings;
        settings.condition = "free_decay";
        settings.sensors = sensors;
        settings.hidden = hidden;
        settings.masses = 2;
        hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
        for (host_sim::Record& record : draw.records)
          record.channels.push_back(
              {"force_1_N", host_sim::Quantity::kForce, 1, std::vector<double>(record.channels.front().values.size())});
        const CoreRun run = run_core(draw);
        const firmware::Estimates& estimates = run.core->estimates();
        EXPECT_TRUE(estimates.warrant.tested) << sensors << " " << hidden << " " << seed;
        EXPECT_EQ(valid_and_wrong(draw, estimates), 0) << sensors << " " << hidden << " " << seed;
        if (settings.hidden == "none") {
          EXPECT_FALSE(suspect(estimates)) << sensors << " " << seed;
        } else {
          withdrawn += suspect(estimates);
        }
      }
  EXPECT_GE(withdrawn, 2);
}

// A sweep that passes a resonance, a blow, a decay: few stretches hold what there is to know of a damping law of another power, and
// their own scatter is hardly known. The noise is alike in all of them.
TEST(Warrant, AFewStretchesThatHoldTheInformationAreEnough) {
  for (const char* condition : {"log_sweep", "hammer"}) {
    int withdrawn = 0, wrong = 0;
    for (const char* hidden : {"quadratic_damping", "cubic_damping"})
      for (uint64_t seed = 8500; seed < 8505; ++seed) {
        Settings settings;
        settings.hidden = hidden;
        settings.condition = condition;
        settings.masses = 1;
        const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
        const CoreRun run = run_core(draw);
        withdrawn += suspect(run.core->estimates());
        wrong += valid_and_wrong(draw, run.core->estimates()) > 0;
      }
    EXPECT_GE(withdrawn, 8) << condition;
    EXPECT_EQ(wrong, 0) << condition;
  }
}

// With accelerometers alone quadratic damping of 0.05 to 0.6 of the damping force often stays below the limit of chance and bends
// its damper all the same, in more than half of the draws. One in eight may pass; one in four did before such a number was UNTESTED.
TEST(Warrant, ADampingLawNearChanceMakesNoNumberValidWhereOneQuantityIsMeasured) {
  int bent = 0, wrong = 0;
  for (const char* condition : {"random_1pct", "random_5pct"})
    for (uint64_t seed = 7000; seed < 7016; ++seed) {
      Settings settings;
      settings.hidden = "quadratic_damping";
      settings.condition = condition;
      settings.sensors = "a";
      const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
      const CoreRun run = run_core(draw);
      wrong += valid_and_wrong(draw, run.core->estimates()) > 0;
      for (int k = 0; k < run.core->estimates().unknown_count; ++k) {
        const firmware::ParameterEstimate& p = run.core->estimates().parameters[k];
        const double truth = draw.coefficients[static_cast<size_t>(k)].value,
                     off = std::abs(to_double(p.value) - truth);
        bent += off > 0.05 * std::abs(truth) && off > 4.0 * to_double(p.std);
      }
    }
  EXPECT_GT(bent, 16);
  EXPECT_LE(wrong, 4);
}

TEST(Warrant, RightModelsKeepTheirNumbers) {
  const char* const kConditions[] = {
      "random_clean", "random_1pct", "random_5pct", "bits_12",     "ar_0p8_1pct",
      "stepped_sine", "log_sweep",   "free_decay",  "moving_base", "masses_springs_unknown",
      "three_levels", "rate_10kHz",  "star",        "rotation",    "tonnes"};
  int valid = 0, all = 0;
  for (const char* condition : kConditions) {
    Settings settings;
    settings.condition = condition;
    settings.masses = std::string(condition) == "star" ? 3 : 2;
    const hidden_rig::Draw draw = hidden_rig::make_draw(8000, settings);
    const CoreRun run = run_core(draw);
    EXPECT_FALSE(suspect(run.core->estimates())) << condition;
    EXPECT_TRUE(run.core->estimates().warrant.tested) << condition;
    for (int k = 0; k < run.core->estimates().unknown_count; ++k, ++all)
      valid += run.core->estimates().parameters[k].status == EstimateStatus::kValid;
  }
  EXPECT_GT(valid, all * 4 / 5) << "of " << all;
}

// Without an acceleration its slope-made stand-in reaches across friction's jump, and shares the velocity's noise with its
// neighbours: neither is a lack of the rig file.
TEST(Warrant, RightModelsWithoutAccelerometersKeepTheirNumbers) {
  for (const char* condition : {"random_clean", "random_1pct", "bits_16"})
    for (int seed = 8001; seed <= 8005; ++seed) {
      Settings settings;
      settings.condition = condition;
      settings.sensors = "xv";
      settings.masses = 3;
      const CoreRun run = run_core(hidden_rig::make_draw(static_cast<uint64_t>(seed), settings));
      EXPECT_FALSE(suspect(run.core->estimates())) << condition << " " << seed;
      EXPECT_TRUE(run.core->estimates().warrant.tested) << condition << " " << seed;
    }
}

// Velocities, with and without accelerations, of a rig that moves when the record begins: the displacement that is integrated
// from them starts as all other signals do. (As long as the first velocity was taken for rest, three times the motion was left of
// that when the estimation began, and nothing was VALID.)
TEST(Warrant, VelocitiesOfARigThatAlreadyMoves) {
  for (const char* sensors : {"va", "v"})
    for (const char* condition : {"random_clean", "random_1pct"}) {
      int valid = 0, all = 0, wrong = 0;
      for (uint64_t seed = 8140; seed < 8148; ++seed) {
        Settings settings;
        settings.condition = condition;
        settings.sensors = sensors;
        settings.masses = 2;
        const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
        const CoreRun run = run_core(draw);
        wrong += valid_and_wrong(draw, run.core->estimates());
        for (int k = 0; k < run.core->estimates().unknown_count; ++k, ++all)
          valid += run.core->estimates().parameters[k].status == EstimateStatus::kValid;
      }
      // a lone velocity shows kinetic energy at a stretch's two ends alone
      const double least = std::string(sensors) == "va" ? 0.75 : 0.5;
      EXPECT_GE(valid, least * all) << sensors << " " << condition << ": " << valid << " of " << all;
      EXPECT_EQ(wrong, 0) << sensors << " " << condition;
    }
}

// Where one DOF has a displacement alone and another an accelerometer or a velocity alone, all signals pass a low-pass and a
// high-pass, and friction's sign has to pass both: its force is found within its interval, whichever DOF has which.
TEST(Warrant, SensorsThatDifferFromDofToDof) {
  int friction = 0, missed = 0, valid = 0, wrong = 0;
  for (uint64_t seed = 8100; seed < 8124; ++seed) {
    Settings settings;
    settings.condition = "random_clean";
    settings.sensors = "mixed";
    settings.masses = 2 + seed % 2;
    const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
    const CoreRun run = run_core(draw);
    if (run.configuration.high_pass_order == 0 || run.configuration.sign_half_length == 0) continue;
    wrong += valid_and_wrong(draw, run.core->estimates());
    for (int k = 0; k < run.core->estimates().unknown_count; ++k) {
      const auto& truth = draw.coefficients[static_cast<size_t>(k)];
      if (truth.name.find("coulomb") == std::string::npos) continue;
      const firmware::ParameterEstimate& p = run.core->estimates().parameters[k];
      ++friction;
      missed += std::abs(to_double(p.value) - truth.value) > 4.0 * to_double(p.std);
      valid += p.status == EstimateStatus::kValid;
    }
  }
  EXPECT_GE(friction, 6);
  EXPECT_GE(3 * valid, friction) << "of " << friction;
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(wrong, 0);
}

TEST(Warrant, TheCauseIsNamedWithItsSize) {
  struct Case {
    const char* hidden;
    firmware::EffectKind effect;
  };
  for (const Case& c : {Case{"cubic_stiffness", firmware::EffectKind::kCubicStiffness},
                        Case{"quadratic_damping", firmware::EffectKind::kQuadraticDamping},
                        Case{"force_offset", firmware::EffectKind::kForceOffset},
                        Case{"asymmetric_viscous", firmware::EffectKind::kAsymmetricViscous}}) {
    Settings settings;
    settings.hidden = c.hidden;
    settings.rho_low = 0.3;
    settings.masses = 2;
    const hidden_rig::Draw draw = hidden_rig::make_draw(9000, settings);
    const CoreRun run = run_core(draw);
    const firmware::Finding& named = run.core->estimates().warrant.named;
    ASSERT_EQ(named.cause, firmware::cause_of(c.effect)) << c.hidden;
    const double strength = draw.hidden.front().strength;
    EXPECT_NEAR(to_double(named.size), strength, 0.05 * std::abs(strength) + 4 * to_double(named.std)) << c.hidden;
  }
}

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

// A damper that fades within a record: its stretches disagree in the order of time, whatever the sensors.
TEST(Warrant, DampingThatDriftsIsNamed) {
  for (const char* sensors : {"xva", "xa", "x", "a"}) {
    Settings settings;
    settings.hidden = "drifting_viscous";
    settings.sensors = sensors;
    settings.rho_low = 0.4;
    settings.masses = 1;
    const CoreRun run = run_core(hidden_rig::make_draw(9100, settings));
    EXPECT_EQ(run.core->estimates().warrant.named.cause, firmware::cause_of(firmware::EffectKind::kDriftingViscous))
        << sensors;
  }
}

// The bottom of a channel's noise is not the continuation of its top: with one channel a DOF the tests need its colour.
TEST(Warrant, LoneChannelsWithColouredNoiseKeepTheirNumbers) {
  for (const char* sensors : {"x", "a"})
    for (const char* condition : {"ar_0p5_1pct", "ar_0p8_1pct"})
      for (int seed = 8301; seed <= 8303; ++seed) {
        Settings settings;
        settings.condition = condition;
        settings.sensors = sensors;
        const hidden_rig::Draw draw = hidden_rig::make_draw(static_cast<uint64_t>(seed), settings);
        const CoreRun run = run_core(draw);
        EXPECT_FALSE(suspect(run.core->estimates())) << sensors << " " << condition << " " << seed;
        EXPECT_EQ(valid_and_wrong(draw, run.core->estimates()), 0) << sensors << " " << condition << " " << seed;
      }
}

// An anti-alias filter smears friction's jumps, and noise in front of it stands in the neighbours of a sample too.
TEST(Warrant, ChannelsBehindAnAntiAliasFilterKeepTheirNumbers) {
  for (const char* sensors : {"xva", "xa", "x"})
    for (const char* condition : {"anti_alias_noise_before", "anti_alias_noise_after"}) {
      int valid = 0, all = 0;
      for (int seed = 8311; seed <= 8314; ++seed) {
        Settings settings;
        settings.condition = condition;
        settings.sensors = sensors;
        settings.masses = 2;
        const hidden_rig::Draw draw = hidden_rig::make_draw(static_cast<uint64_t>(seed), settings);
        const CoreRun run = run_core(draw);
        EXPECT_FALSE(suspect(run.core->estimates())) << sensors << " " << condition << " " << seed;
        EXPECT_EQ(valid_and_wrong(draw, run.core->estimates()), 0) << sensors << " " << condition << " " << seed;
        for (int k = 0; k < run.core->estimates().unknown_count; ++k, ++all)
          valid += run.core->estimates().parameters[k].status == EstimateStatus::kValid;
      }
      EXPECT_GT(valid, all / 2) << sensors << " " << condition;
    }
}

// Five to seven samples a period: the tests' neighbours move against the sample, and slopes of channels are not exact.
TEST(Warrant, RightModelsOfFewSamplesAPeriodAreNotAccused) {
  for (const char* sensors : {"xva", "xa"})
    for (int seed = 8321; seed <= 8326; ++seed) {
      Settings settings;
      settings.condition = "rate_200Hz";
      settings.sensors = sensors;
      const hidden_rig::Draw draw = hidden_rig::make_draw(static_cast<uint64_t>(seed), settings);
      const CoreRun run = run_core(draw);
      EXPECT_FALSE(suspect(run.core->estimates())) << sensors << " " << seed;
      EXPECT_EQ(valid_and_wrong(draw, run.core->estimates()), 0) << sensors << " " << seed;
    }
}

// One tone at one level: damping laws of different powers look the same. Two levels tell them apart.
TEST(Warrant, OneToneAtOneLevelIsUntested) {
  Settings settings;
  settings.condition = "sine_records";  // two frequencies at two levels, a record each
  settings.masses = 1;
  hidden_rig::Draw draw = hidden_rig::make_draw(8100, settings);
  const CoreRun all = run_core(draw);
  draw.records.resize(1);
  const CoreRun one = run_core(draw);
  for (int k = 0; k < one.core->estimates().unknown_count; ++k) {
    EXPECT_NE(one.core->estimates().parameters[k].status, EstimateStatus::kValid);
    EXPECT_NE(all.core->estimates().parameters[k].status, EstimateStatus::kUntested);
  }
  EXPECT_EQ(one.core->estimates().parameters[0].status, EstimateStatus::kUntested);
}

uint32_t blocks(const CoreRun& run) {
  uint32_t sum = 0;
  const firmware::ScoreTable& table = run.core->score_tests().sums().table();
  for (int s = 0; s < table.stretches(); ++s) sum += table.stretch(s).blocks;
  return sum;
}

// The default looks at every sample of a level's start, 32768 of them in 1024 blocks of 32, and at some of what follows. A record
// that is no longer has the same answer as with all; 12 and 4 products a DOF leave most of the rest out.
TEST(Warrant, TheDefaultBudgetLooksAtAllOfALevelsStart) {
  Settings settings;
  settings.hidden = "cubic_stiffness";
  settings.masses = 1;
  const hidden_rig::Draw draw = hidden_rig::make_draw(8210, settings);  // 20 s at 1 kHz
  const CoreRun all = run_core(draw), usual = run_core(draw, firmware::kDefaultProbes);
  EXPECT_EQ(blocks(usual), blocks(all));
  settings.condition = "seconds_120";
  const hidden_rig::Draw long_draw = hidden_rig::make_draw(8210, settings);
  const CoreRun of_long = run_core(long_draw, firmware::kDefaultProbes);
  EXPECT_TRUE(suspect(of_long.core->estimates()));
  EXPECT_GT(blocks(of_long), 1024u);
  EXPECT_LT(blocks(of_long), 1024u + (120000u / 32u - 1024u) / 8u);
}

// What a budget leaves out could hold a force that bends a coefficient: then it is UNTESTED, not VALID.
TEST(Warrant, WhatABudgetCannotTestIsNotValid) {
  int wrong = 0, untested = 0, wrong_without = 0;
  for (const char* hidden : {"quadratic_damping", "cubic_damping", "displacement_dependent_damping"})
    for (uint64_t seed = 8220; seed < 8224; ++seed) {
      Settings settings;
      settings.hidden = hidden;
      settings.rho_low = 0.2;
      settings.masses = 2;
      const hidden_rig::Draw draw = hidden_rig::make_draw(seed, settings);
      const CoreRun some = run_core(draw, 30), none = run_core(draw, 0);
      wrong += valid_and_wrong(draw, some.core->estimates()) > 0;
      wrong_without += valid_and_wrong(draw, none.core->estimates()) > 0;
      for (int k = 0; k < some.core->estimates().unknown_count; ++k)
        untested += some.core->estimates().parameters[k].status == EstimateStatus::kUntested;
    }
  EXPECT_LE(wrong, 1);
  EXPECT_GT(untested, 0);
  EXPECT_GT(wrong_without, 4);  // there was something to say
}

// A budget leaves blocks out; what is strong is seen all the same, and the estimates keep every bit.
TEST(Warrant, ABudgetCostsSensitivityNotEstimates) {
  Settings settings;
  settings.hidden = "cubic_stiffness";
  settings.rho_low = 0.5;
  settings.masses = 1;
  const hidden_rig::Draw draw = hidden_rig::make_draw(8200, settings);
  const CoreRun whole = run_core(draw), some = run_core(draw, 60), none = run_core(draw, 0);
  EXPECT_TRUE(suspect(whole.core->estimates()));
  EXPECT_TRUE(suspect(some.core->estimates()));
  EXPECT_FALSE(none.core->estimates().warrant.tested);
  EXPECT_LT(blocks(some), blocks(whole) / 4);
  for (int k = 0; k < whole.core->estimates().unknown_count; ++k) {
    const firmware::ParameterEstimate &a = whole.core->estimates().parameters[k],
                                      &b = none.core->estimates().parameters[k];
    EXPECT_EQ(a.value.mantissa, b.value.mantissa);
    EXPECT_EQ(a.std.mantissa, b.std.mantissa);
  }
}

}  // namespace

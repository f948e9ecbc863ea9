// Statuses and advice on tables small enough to see why.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firmware/identification/conditions/natural_frequencies.hpp"
#include "tests/identification/hand_table.hpp"

using firmware::Advice;
using firmware::EstimateStatus;
using firmware::TermKind;
using hand::HandTable;

namespace {

HandTable two_dampers() {
  HandTable t(1, {TermKind::kViscous, TermKind::kCoulomb}, {{0}, {0}});
  t.link(0, firmware::kGroundNode);
  t.link(0, firmware::kGroundNode);
  return t;
}

}  // namespace

TEST(Status, EmptyTableIsStale) {
  HandTable t = two_dampers();
  t.identify();
  EXPECT_EQ(t.status(0), EstimateStatus::kStale);
  EXPECT_EQ(t.estimates->rows, 0u);
}

// Columns (1, 1) and (4, 4.004): nearly one direction. Column-scaled and weighted by energy the rows are (1, 1) and
// (1, 1.001); the inflation is 1 / sin of the angle between the columns, about 2 / 0.001 = 2000.
TEST(Status, ParallelColumnsAreIllConditioned) {
  HandTable t = two_dampers();
  t.level(true);
  for (int b = 0; b < 4; ++b) t.batch({{{1, 1}, 2, 0, 0, 1.0}});
  t.level(true);
  for (int b = 0; b < 4; ++b) t.batch({{{4, 4.004}, 8.004, 0, 0, 4.0}});
  t.identify();
  EXPECT_EQ(t.status(0), EstimateStatus::kIllConditioned);
  EXPECT_EQ(t.status(1), EstimateStatus::kIllConditioned);
  EXPECT_TRUE(t.estimates->inseparable);
  EXPECT_NEAR(rig_file::to_double(t.estimates->parameters[0].variance_inflation), 2000.0, 10.0);
  EXPECT_GT(rig_file::to_double(t.estimates->condition_number), 1000.0);
  EXPECT_EQ(t.estimates->advice, Advice::kAddFrequency);
  // The combination that the rows do not see: p0 up, p1 down by as much; both are 1, so also relative to their values.
  EXPECT_NEAR(rig_file::to_double(t.estimates->unresolved[0]) * rig_file::to_double(t.estimates->unresolved[1]), -1.0,
              0.01);
}

// One level gives one equation for two unknowns: nothing can be said, whatever the solver's numbers are.
TEST(Status, FewerRowsThanUnknownsAreIllConditioned) {
  HandTable t = two_dampers();
  t.level(true);
  t.batch({{{2, 1}, 11}});
  t.identify();
  EXPECT_EQ(t.status(0), EstimateStatus::kIllConditioned);
  EXPECT_EQ(t.status(1), EstimateStatus::kIllConditioned);
  EXPECT_EQ(t.estimates->advice, Advice::kAddLevel);
}

// Rows whose energies are as noisy as they are large, as short rows of a decay are: noise of 40 J beside 40 J of work. Where the
// discrepancies show all but 0.01 J of it the damper is known to 0.01 / 2 / sqrt(40), and noise in its columns, a part of that,
// cannot bend it. Where they do not, its deviation is 16 % and what the columns' noise may do is more than itself.
TEST(Status, NoiseThatDiscrepanciesShowConditionsNothing) {
  for (const bool shown : {true, false}) {
    HandTable t(1, {TermKind::kViscous}, {{0}});
    t.link(0, firmware::kGroundNode);
    t.level(false);
    for (int b = 0; b < 40; ++b) {
      const double noise = b % 2 ? 40.0 : -40.0, left = b / 2 % 2 ? 0.01 : -0.01;
      t.batch({{{2}, 40.0 + noise + left, shown ? noise : 0.0, 0, 2.0}});
    }
    t.identify();
    EXPECT_EQ(t.status(0), shown ? EstimateStatus::kValid : EstimateStatus::kIllConditioned);
    if (shown) {
      EXPECT_NEAR(t.value(0), 20.0, 0.01);
    }
  }
}

TEST(Status, UnknownWithoutAnyWorkIsNotExcited) {
  HandTable t = two_dampers();
  t.level(true);
  for (int b = 0; b < 4; ++b) t.batch({{{2, 0}, 6}});
  t.level(true);
  for (int b = 0; b < 4; ++b) t.batch({{{8, 0}, 24}});
  t.identify();
  EXPECT_EQ(t.status(0), EstimateStatus::kValid);
  EXPECT_NEAR(t.value(0), 3.0, 1e-12);
  EXPECT_EQ(t.status(1), EstimateStatus::kNoExcitation);
  EXPECT_EQ(t.estimates->advice, Advice::kRaiseLevel);
  EXPECT_EQ(t.estimates->advice_index, 1);
}

// Work of changing sign that adds up to nothing (3 - 3 + 3 - 3) is noise, not motion.
TEST(Status, WorkWithoutASignIsNotExcited) {
  HandTable t = two_dampers();
  t.level(false);
  for (int b = 0; b < 12; ++b) t.batch({{{2, b % 2 ? 0.3 : -0.3}, 6}});
  t.identify();
  EXPECT_EQ(t.status(1), EstimateStatus::kNoExcitation);
}

// An arm held out, a shaft that runs on: the mass's work is now lent and now given back, 3 J each, and adds up to nothing. The damper
// to the ground takes 2 J every time: so it moves. One to a neighbour may move by the neighbour alone.
TEST(Status, WhatDissipatesToTheGroundTellsThatAMassMoves) {
  for (const bool ground : {true, false}) {
    HandTable t(2, {TermKind::kMass, TermKind::kViscous}, {{0}, {0, 1}});
    t.link(0, ground ? firmware::kGroundNode : 1);
    for (int k = 0; k < t.configuration.term_count; ++k) t.configuration.terms[k].place = 0;
    t.level(false);
    for (int b = 0; b < 12; ++b) {
      const double lent = b % 2 ? 3.0 : -3.0;
      t.batch({{{lent, 2}, 5 * lent + 6}, {{0}, 0}});
    }
    t.identify();
    EXPECT_EQ(t.status(0) == EstimateStatus::kNoExcitation, !ground);
    EXPECT_NE(t.status(1), EstimateStatus::kNoExcitation);
  }
}

TEST(Status, SaturatedLevelMarksAll) {
  HandTable t = two_dampers();
  t.level(true);
  for (int b = 0; b < 4; ++b) t.batch({{{2, 1}, 11}});
  t.level(true);
  for (int b = 0; b < 4; ++b) t.batch({{{8, 2}, 34}});
  t.table->level[1].saturated = true;
  t.identify();
  EXPECT_EQ(t.status(0), EstimateStatus::kSaturated);
  EXPECT_EQ(t.estimates->advice, Advice::kLowerLevel);
}

// Displacement late by 250 us: elastic discrepancy = -tau V. With k = 1e4 N/m it adds k tau = 2.5 N s/m to the viscous
// coefficient: 12 % of 20, so SKEWED. Column V = 2, rhs (20 + 2.5) V = 45.
TEST(Status, LateDisplacementIsMeasuredAndMarked) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.known(TermKind::kStiffness, 0, 1e4);
  t.level(true);
  for (int b = 0; b < 12; ++b) {
    const double noise = b % 2 ? 1e-6 : -1e-6;
    t.batch({{{2}, 45.0 + noise, 0, -250e-6 * 2.0 + noise, 2.0}});
  }
  t.identify();
  const firmware::SkewEstimate& skew = t.estimates->displacement_skew[0];
  EXPECT_TRUE(skew.significant);
  EXPECT_NEAR(rig_file::to_double(skew.late_s), 250e-6, 1e-9);
  EXPECT_EQ(t.status(0), EstimateStatus::kSkewed);
  EXPECT_EQ(t.estimates->advice, Advice::kCompensateSkew);
}

// Acceleration late by 200 us: kinetic discrepancy = +tau integral(a^2).
TEST(Status, LateAccelerationIsMeasured) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.level(true);
  for (int b = 0; b < 12; ++b) t.batch({{{2}, 40.0, 200e-6 * 50.0 + (b % 2 ? 1e-7 : -1e-7), 0, 2.0, 50.0}});
  t.identify();
  EXPECT_TRUE(t.estimates->acceleration_skew[0].significant);
  EXPECT_NEAR(rig_file::to_double(t.estimates->acceleration_skew[0].late_s), 200e-6, 1e-9);
}

// 20 us of 1 ms are less than what friction imitates at the most, 1/16 of a sample period, and more than what no friction does.
// The acceleration is sqrt(50 / T) rms in T = 1 s a batch: 7.07 m/s^2, 14.1 N of 2 kg. Of 0.3 N the least delay is
// 1 ms * 0.3 / (3 * 14.1) = 7 us, of 3 N 71 us, of which 1/16 ms = 62.5 us are left.
TEST(Status, WhatFrictionMayImitateIsNoDelay) {
  for (const auto& [friction_N, late_us, delayed] :
       {std::tuple{0.0, 20.0, true}, {0.3, 6.0, false}, {0.3, 8.0, true}, {3.0, 60.0, false}, {3.0, 65.0, true}}) {
    HandTable t(1, {TermKind::kViscous}, {{0}});
    t.link(0, firmware::kGroundNode);
    t.known(TermKind::kMass, 0, 2.0);
    if (friction_N != 0.0) t.known(TermKind::kCoulomb, 0, friction_N);
    t.table->sample_period_s = rig_file::to_scaled(1e-3);
    t.level(true);
    for (int b = 0; b < 12; ++b) {
      t.batch({{{2}, 40.0, late_us * 1e-6 * 50.0 + (b % 2 ? 1e-7 : -1e-7), 0, 2.0, 50.0}});
      t.table->level[0].batch[b].samples = 1000;
    }
    t.identify();
    EXPECT_EQ(t.estimates->acceleration_skew[0].significant, delayed) << friction_N << " N, " << late_us << " us";
  }
}

// Plain rhs 10 % above the instrumented one in every batch: the plain estimate reads 22 instead of 20, far outside the
// interval: the value rests on the instrument alone.
TEST(Status, PlainEstimateFarFromTheInstrumentedOneIsSuspect) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.level(true);
  for (int b = 0; b < 12; ++b) t.batch({{{2}, 40.0 + (b % 2 ? 0.01 : -0.01), 0, 0, 2.0, 0, 4.0}});
  t.identify();
  EXPECT_NEAR(t.value(0), 20.0, 1e-9);
  EXPECT_NEAR(rig_file::to_double(t.estimates->parameters[0].plain_value), 22.0, 1e-6);
  EXPECT_EQ(t.status(0), EstimateStatus::kBiasSuspect);
}

// Two masses of 1 kg in a chain of three springs of 1 N/m between walls: omega^2 = 1 and 3.
TEST(NaturalFrequencies, ChainOfTwo) {
  HandTable t(2, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.link(0, 1);
  t.link(1, firmware::kGroundNode);
  for (int i : {0, 1}) t.known(TermKind::kMass, i, 1.0);
  for (int l : {0, 1, 2}) t.known(TermKind::kStiffness, l, 1.0);
  firmware::Scaled frequencies[firmware::kMaxDofs];
  ASSERT_TRUE(firmware::natural_frequencies_Hz(t.configuration, *t.estimates, frequencies));
  const double a = rig_file::to_double(frequencies[0]), b = rig_file::to_double(frequencies[1]);
  EXPECT_NEAR(std::min(a, b), 0.159155, 1e-6);
  EXPECT_NEAR(std::max(a, b), 0.275664, 1e-6);
}

// Three masses of 1 kg between four springs of 1 N/m: omega^2 = 2 - sqrt 2, 2 and 2 + sqrt 2.
TEST(NaturalFrequencies, ChainOfThree) {
  HandTable t(3, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.link(0, 1);
  t.link(1, 2);
  t.link(2, firmware::kGroundNode);
  for (int i : {0, 1, 2}) t.known(TermKind::kMass, i, 1.0);
  for (int l : {0, 1, 2, 3}) t.known(TermKind::kStiffness, l, 1.0);
  firmware::Scaled frequencies[firmware::kMaxDofs];
  ASSERT_TRUE(firmware::natural_frequencies_Hz(t.configuration, *t.estimates, frequencies));
  double found[3];
  for (int i = 0; i < 3; ++i) found[i] = rig_file::to_double(frequencies[i]);
  std::sort(found, found + 3);
  EXPECT_NEAR(found[0], 0.121812, 1e-6);
  EXPECT_NEAR(found[1], 0.225079, 1e-6);
  EXPECT_NEAR(found[2], 0.294080, 1e-6);
}

// Numbers of a motion that was read from its end.
#include "firmware/identification/rows/backward_time.hpp"

#include <gtest/gtest.h>

#include "tests/identification/hand_table.hpp"

using firmware::cause_of;
using firmware::EffectKind;
using firmware::EstimateStatus;
using firmware::TermKind;
using hand::HandTable;
using rig_file::to_double;

namespace {

// Damper, friction, spring and a damper of one direction of one link, read backwards: m x" - c x' - F sgn(x') + k x - d |x'| = 0 has the
// sum c x' + F sgn(x') turned over alone; |x'| is the same from both ends.
HandTable read_back() {
  HandTable t(1, {TermKind::kViscous, TermKind::kCoulomb, TermKind::kStiffness, TermKind::kAsymmetricViscous},
              {{0}, {0}, {0}, {0}});
  t.link(0, firmware::kGroundNode);
  t.configuration.time_runs_back = true;
  t.estimates->unknown_count = 4;
  for (int k = 0; k < 4; ++k) {
    firmware::ParameterEstimate& p = t.estimates->parameters[k];
    p.value = firmware::Scaled::from_int(-3), p.plain_value = firmware::Scaled::from_int(-2);
    p.ci95_low = firmware::Scaled::from_int(-5), p.ci95_high = firmware::Scaled::from_int(-1);
  }
  return t;
}

TEST(BackwardTime, WhatDissipatesIsTurnedOver) {
  HandTable t = read_back();
  firmware::run_forward(t.configuration, *t.estimates);
  for (int k = 0; k < 4; ++k) {
    const firmware::ParameterEstimate& p = t.estimates->parameters[k];
    const bool turned = k < 2;
    EXPECT_EQ(firmware::turns_over(t.configuration, k), turned) << k;
    EXPECT_EQ(to_double(p.value), turned ? 3.0 : -3.0) << k;
    EXPECT_EQ(to_double(p.plain_value), turned ? 2.0 : -2.0) << k;
    EXPECT_EQ(to_double(p.ci95_low), turned ? 1.0 : -5.0) << k;
    EXPECT_EQ(to_double(p.ci95_high), turned ? 5.0 : -1.0) << k;
  }
}

TEST(BackwardTime, WhatIsLateWasEarly) {
  HandTable t = read_back();
  t.estimates->acceleration_skew[0].late_s = firmware::Scaled::ratio(1, 1000);
  t.estimates->warrant.named.cause = cause_of(EffectKind::kSensorDelay);
  t.estimates->warrant.named.size = firmware::Scaled::ratio(1, 500);
  t.estimates->warrant.rival.cause = cause_of(EffectKind::kCubicStiffness);
  t.estimates->warrant.rival.size = firmware::Scaled::from_int(7);
  firmware::run_forward(t.configuration, *t.estimates);
  EXPECT_NEAR(to_double(t.estimates->acceleration_skew[0].late_s), -1e-3, 1e-9);
  EXPECT_NEAR(to_double(t.estimates->warrant.named.size), -2e-3, 1e-9);
  EXPECT_EQ(to_double(t.estimates->warrant.rival.size), 7.0);
}

TEST(BackwardTime, NothingIsTurnedWhereTimeRunsAsItDoes) {
  HandTable t = read_back();
  const firmware::Scaled two = firmware::Scaled::from_int(2);
  EXPECT_EQ(to_double(firmware::forwards(t.configuration, TermKind::kViscous, two)), -2.0);
  EXPECT_EQ(to_double(firmware::forwards(t.configuration, TermKind::kStiffness, two)), 2.0);
  t.configuration.time_runs_back = false;
  EXPECT_EQ(to_double(firmware::forwards(t.configuration, TermKind::kViscous, two)), 2.0);
  EXPECT_FALSE(firmware::turns_over(t.configuration, 0));
}

}  // namespace

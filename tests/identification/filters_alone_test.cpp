// Windows that hold what the high-pass has left of a motion that is over.
#include <gtest/gtest.h>

#include "tests/identification/hand_table.hpp"

using firmware::EstimateStatus;
using firmware::Quantity;
using firmware::TermKind;
using hand::DofEntry;
using hand::HandTable;

namespace {

constexpr int kShift = 9;                  // tau = 2^9 samples of 1 ms
constexpr double kTimeConstant_s = 0.512;  // and half of it times 1 m^2/s of v^2 dt is 0.256 m^2
constexpr double kSlow_m2 = 0.26, kFast_m2 = 0.25;

// A damper, energies of 2 J +- 1 % for 1 J per N s/m: 2 N s/m, well known. The displacement changes x^2 / 2 by so much in each batch,
// back and forth.
HandTable one_damper(double change_m2, bool integrated) {
  HandTable t(1, {TermKind::kViscous}, {{0}});
  t.link(0, firmware::kGroundNode);
  t.configuration.high_pass_order = 2;
  t.configuration.high_pass_shift = kShift;
  auto& displacement = t.configuration.signals[0][static_cast<int>(Quantity::kDisplacement)];
  displacement.available = true;
  displacement.integrations = integrated ? 1 : 0;
  t.level(false);
  for (int b = 0; b < 40; ++b) {
    DofEntry entry{{1.0}, b % 4 < 2 ? 2.02 : 1.98};
    entry.elastic_end = b % 2 == 0 ? change_m2 : -change_m2;
    t.batch({entry});
  }
  return t;
}

EstimateStatus status(double change_m2, bool integrated = true) {
  HandTable t = one_damper(change_m2, integrated);
  t.identify();
  EXPECT_NEAR(t.value(0), 2.0, 1e-6);
  return t.status(0);
}

}  // namespace

// exp(-t / tau) has |x v| = tau v^2: all that it says of a damper is tau times the stiffness. Half of that is the bound.
TEST(FiltersAlone, WhatFallsWithTheirTimeConstantIsNoMotion) {
  EXPECT_EQ(status(kTimeConstant_s), EstimateStatus::kIllConditioned);
  EXPECT_EQ(status(kSlow_m2), EstimateStatus::kIllConditioned);
  EXPECT_EQ(status(kFast_m2), EstimateStatus::kValid);
}

TEST(FiltersAlone, AMeasuredDisplacementMayBeAsSlowAsItLikes) {
  EXPECT_EQ(status(kTimeConstant_s, false), EstimateStatus::kValid);
}

// The slow DOF's neighbour moves, and its own damper to the ground is known all the same; the one between them is not.
TEST(FiltersAlone, OnlyEquationsOfTheSlowDofAreInDoubt) {
  HandTable t(2, {TermKind::kViscous, TermKind::kViscous}, {{0, 1}, {1}});
  t.link(0, 1);
  t.link(1, firmware::kGroundNode);
  t.configuration.high_pass_order = 2;
  t.configuration.high_pass_shift = kShift;
  for (int dof = 0; dof < 2; ++dof)
    t.configuration.signals[dof][static_cast<int>(Quantity::kDisplacement)].integrations = 1;
  t.level(false);
  for (int b = 0; b < 40; ++b) {
    DofEntry slow{{1.0}, b % 4 < 2 ? 2.02 : 1.98}, moving{{-0.5, 1.0}, b % 8 < 4 ? 2.02 : 1.98};
    slow.elastic_end = b % 2 == 0 ? kTimeConstant_s : -kTimeConstant_s;
    t.batch({slow, moving});
  }
  t.identify();
  EXPECT_EQ(t.status(0), EstimateStatus::kIllConditioned);
  EXPECT_EQ(t.status(1), EstimateStatus::kValid);
  EXPECT_NEAR(t.value(1), 3.0, 0.05);  // 2 = -0.5 * 2 + c
}

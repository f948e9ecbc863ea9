// Effects as sentences say them: one spelling, wherever they stand.
#include "host_sim/vocabulary/said.hpp"

#include <gtest/gtest.h>

namespace {

using vocabulary::said;

TEST(Said, AnEffectAndItsPlace) {
  EXPECT_EQ(said("quadratic_damping", "link 1-0"), "quadratic damping on link 1-0");
  EXPECT_EQ(said("mass_error", "dof 2"), "mass error on DOF 2");
  EXPECT_EQ(said("sensor_delay", "channel force_1_N"), "sensor delay in channel force_1_N");
  EXPECT_EQ(said("end_stop", ""), "end stop");
}

// "lacks missing coulomb" would be there.
TEST(Said, WhatMayBeMissingIsCalledByWhatItIs) {
  EXPECT_EQ(said("missing_coulomb", "link 1-0"), "Coulomb friction on link 1-0");
  EXPECT_EQ(said("missing_viscous", "link 2-0"), "viscous damping on link 2-0");
  EXPECT_EQ(said("missing_gravity_torque", "link 1-0"), "gravity torque on link 1-0");
}

}  // namespace

// The force of each term on motions whose forces are known in closed form.
#include "host_sim/force_balance/force_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/force_balance/derivative.hpp"

namespace {

using namespace host_sim;

constexpr double kPeriod_s = 0.01;

// x1 = 1 + t^2, so v1 = 2 t and a1 = 2; x2 = 3 t, so v2 = 3 and a2 = 0. Only displacements are recorded: the
// derivatives of a parabola come out exactly.
Record record_of(size_t samples, double force_N) {
  Record record;
  record.sample_period_s = kPeriod_s;
  record.channels = {{"force_1_N", Quantity::kForce, 1, std::vector<double>(samples, force_N)},
                     {"displacement_1_m", Quantity::kDisplacement, 1, {}},
                     {"displacement_2_m", Quantity::kDisplacement, 2, {}}};
  for (size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * kPeriod_s;
    record.channels[1].values.push_back(1.0 + t * t);
    record.channels[2].values.push_back(3.0 * t);
  }
  return record;
}

constexpr char kRig[] = R"(schema = "rig/1"
name = "two masses"
[[dof]]
mass_kg = 2.0
[[dof]]
mass_kg = 5.0
[[link]]
between = [1, 0]
stiffness_N_m = 100.0
[[link]]
between = [1, 2]
viscous_N_s_m = 4.0
coulomb_N = 0.5
[[link.effect]]
kind = "cubic_stiffness"
coefficient = 7.0
)";

// At time t: link 1-0 has u = 1 + t^2; link 1-2 has u = 1 + t^2 - 3 t and w = 2 t - 3 (negative for t < 1.5).
// DOF 1: residual = f - 2 * 2 - 100 (1 + t^2) - [4 w - 0.5 + 7 u^3]; DOF 2: residual = -5 * 0 + [4 w - 0.5 + 7 u^3].
TEST(ForceBalance, EveryTermOnAKnownMotion) {
  const ForceBalance balance = force_balance(rig_file::parse_rig(kRig, "rig.toml"), record_of(100, 300.0));
  ASSERT_EQ(balance.residual.size(), 2u);
  ASSERT_EQ(balance.residual[0].size(), 92u);
  for (size_t i = 0; i < 92; ++i) {
    const double t = static_cast<double>(i + kDerivativeMargin) * kPeriod_s;
    const double u = 1.0 + t * t - 3.0 * t, w = 2.0 * t - 3.0;
    const double between = 4.0 * w - 0.5 + 7.0 * u * u * u;
    EXPECT_NEAR(balance.residual[0][i], 300.0 - 4.0 - 100.0 * (1.0 + t * t) - between, 1e-8);
    EXPECT_NEAR(balance.residual[1][i], between, 1e-8);
    EXPECT_NEAR(balance.velocity[0][i], 2.0 * t, 1e-10);
    EXPECT_NEAR(balance.inertia[0][i], 4.0, 1e-8);
  }
}

TEST(ForceBalance, TermsHaveTheNamesOfTheParameters) {
  const ForceBalance balance = force_balance(rig_file::parse_rig(kRig, "rig.toml"), record_of(100, 300.0));
  ASSERT_EQ(balance.links.size(), 2u);
  ASSERT_EQ(balance.links[0].terms.size(), 1u);
  EXPECT_EQ(balance.links[0].terms[0].name, "stiffness[1-0]");
  EXPECT_TRUE(balance.links[0].terms[0].conservative);
  ASSERT_EQ(balance.links[1].terms.size(), 3u);
  EXPECT_EQ(balance.links[1].terms[0].name, "viscous[1-2]");
  EXPECT_FALSE(balance.links[1].terms[0].conservative);
  EXPECT_EQ(balance.links[1].terms[1].name, "coulomb[1-2]");
  EXPECT_EQ(balance.links[1].terms[2].name, "cubic_stiffness[1-2]");
  EXPECT_NEAR(balance.links[1].terms[1].force[0], -0.5, 1e-15);
}

TEST(ForceBalance, WithoutAForceTheReferenceIsTheInertia) {
  Record record = record_of(100, 300.0);
  record.channels.erase(record.channels.begin());
  const ForceBalance balance = force_balance(rig_file::parse_rig(kRig, "rig.toml"), record);
  EXPECT_NEAR(balance.reference[0][10], 4.0, 1e-8);
  EXPECT_EQ(balance.drive[0][10], 0.0);
}

}  // namespace

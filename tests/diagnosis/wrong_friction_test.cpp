// A rig file that states the friction of its link, and has it wrong; displacement and force alone.
#include <gtest/gtest.h>

#include "one_mass.hpp"
#include "two_masses.hpp"

namespace {

using namespace two_masses;
using one_mass::kViscous_N_s_m;

constexpr double kCoulomb_N = 2;

host_sim::Record record(uint64_t seed) {
  return one_mass::record([](double) { return kCoulomb_N; }, seed);
}

// What is said for friction of so much in the rig file: what is missing to 2 N, and the damper.
void expect_friction(double stated_N, uint64_t seed) {
  rig_file::RigModel rig = one_mass::rig();
  rig.links[0].coulomb_N.value = stated_N;
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {record(seed)}, {});
  ASSERT_EQ(d.causes.size(), 1u) << stated_N << " N: " << said(d);
  EXPECT_EQ(d.causes[0].effect, "missing_coulomb") << stated_N << " N: " << said(d);
  EXPECT_NEAR(value_of(d.extended, "missing_coulomb[1-0]"), kCoulomb_N - stated_N, 0.1) << stated_N;
  EXPECT_NEAR(value_of(d.extended, "viscous[1-0]"), kViscous_N_s_m, 0.03 * kViscous_N_s_m) << stated_N;
  EXPECT_NEAR(d.extended_rig.links[0].coulomb_N.value, kCoulomb_N, 0.1) << stated_N;
}

// It was never asked: damping laws stood for it, and the damper went out VALID 25 to 100 % off.
TEST(WrongFriction, TooMuchIsTakenOff) { expect_friction(2.6, 1), expect_friction(3, 2); }

TEST(WrongFriction, TooLittleIsAdded) { expect_friction(1.5, 3); }

// A friction that falls with the rate was named first, and the damper was 9 to 18 % off, VALID.
TEST(WrongFriction, NoneIsDryFriction) { expect_friction(0, 4), expect_friction(0, 5); }

}  // namespace

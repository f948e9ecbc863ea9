// A rig file that states the friction of its link, and has it wrong; displacement and force alone. The plant is the test's own: fourth
// order Runge-Kutta, friction that turns over within 1 mm/s.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;
using host_sim::Quantity;

constexpr double kTwoPi = 6.283185307179586;
constexpr double kMass_kg = 3, kStiffness_N_m = 7580, kViscous_N_s_m = 10, kCoulomb_N = 2;

host_sim::Record record(uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, kTwoPi);
  std::vector<double> omega, start;
  for (int i = 0; i < 40; ++i) omega.push_back(kTwoPi * (2 + 0.35 * i)), start.push_back(phase(random));
  const auto drive_N = [&](double t) {
    double sum = 0;
    for (size_t i = 0; i < omega.size(); ++i) sum += std::sin(omega[i] * t + start[i]);
    return 2.5 * sum;
  };
  const auto acceleration = [&](double t, double x, double v) {
    return (drive_N(t) - kStiffness_N_m * x - kViscous_N_s_m * v - kCoulomb_N * std::tanh(v / 1e-3)) / kMass_kg;
  };
  host_sim::Record made;
  made.file = "rig.csv", made.sample_period_s = 2e-3;
  std::vector<double> force, place;
  const double h = 2e-4;
  double x = 0, v = 0;
  for (int k = 0; k < 100000; ++k) {
    const double t = k * h;
    if (k % 10 == 0) force.push_back(drive_N(t) + 0.05 * normal(random)), place.push_back(x + 2e-5 * normal(random));
    const double a1 = acceleration(t, x, v), a2 = acceleration(t + h / 2, x + h / 2 * v, v + h / 2 * a1),
                 a3 = acceleration(t + h / 2, x + h / 2 * (v + h / 2 * a1), v + h / 2 * a2),
                 a4 = acceleration(t + h, x + h * (v + h / 2 * a2), v + h * a3);
    x += h * v + h * h / 6 * (a1 + a2 + a3), v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  made.channels = {{"force_1_N", Quantity::kForce, 1, force}, {"displacement_1_m", Quantity::kDisplacement, 1, place}};
  return made;
}

// What is said for friction of so much in the rig file: what is missing to 2 N, and the damper.
void expect_friction(double stated_N, uint64_t seed) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = kMass_kg;
  rig.links[0].a = 1;
  rig.links[0].stiffness_N_m.value = kStiffness_N_m, rig.links[0].viscous_N_s_m.estimate = true;
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

// A cart without a spring that a constant force pulls along: a cable, a slope.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "one_mass.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;

constexpr double kMass_kg = 6.28, kViscous_N_s_m = 5, kFriction_N = 2, kPull_N = 1.9;

// 20 s at 150 Hz of a relay that holds it in its place, 13.3 N one way or the other: it turns where the place was eight samples ago. In
// steps of an explicit Euler of 1/60,000 s. The velocity alone, beside noise of 2 %.
host_sim::Record held_by_a_relay(unsigned seed) {
  constexpr size_t kLate = 8;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const double h = 1.0 / 60000;
  std::vector<double> f, v, x;
  double speed = 0, place = 0.01, force = 0;
  for (int n = 0; n < 1200000; ++n) {
    if (n % 400 == 0) {
      const size_t k = x.size();
      force = (k < kLate ? place : x[k - kLate]) > 0 ? -13.3 : 13.3;
      f.push_back(force), v.push_back(speed), x.push_back(place);
    }
    const double pull = force - kPull_N - kViscous_N_s_m * speed;
    place += h * speed;
    const double sign = speed != 0 ? std::copysign(1, speed) : std::copysign(1, pull);
    if (speed == 0 && std::abs(pull) <= kFriction_N) continue;
    const double next = speed + h * (pull - kFriction_N * sign) / kMass_kg;
    speed = speed * next < 0 ? 0 : next;
  }
  one_mass::add_noise(0.02, random, normal, v);
  host_sim::Record record;
  record.file = "cart.csv", record.sample_period_s = 1.0 / 150;
  record.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, f},
                     {"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, v}};
  return record;
}

// The velocity alone tells it: no spring pulls back, so it does not only move what the mass rests at.
TEST(UnsprungOffset, IsNamed) {
  rig_file::RigModel rig = one_mass::rig(kMass_kg, 0);
  rig.links[0].coulomb_N.estimate = true;
  for (const unsigned seed : {1u, 2u}) {
    const Diagnosis d = diagnose(rig, {held_by_a_relay(seed)}, {}, {});
    ASSERT_EQ(d.causes.size(), 1u) << two_masses::said(d);
    EXPECT_EQ(d.causes[0].effect, "force_offset") << two_masses::said(d) << " " << seed;
    ASSERT_FALSE(d.causes[0].parameters.empty());
    EXPECT_NEAR(d.causes[0].parameters[0].value, kPull_N, 0.1);
    EXPECT_GT(d.causes[0].significance, 9);
  }
}

}  // namespace

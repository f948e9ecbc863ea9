// Free decays of one frequency by an accelerometer of a phone, six samples a period: closed forms with noise.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;

constexpr double kStiffness_N_m = 377, kViscous_N_s_m = 1.2;  // of 1 kg

// x = e^(-c t / 2) cos(w t), w^2 = k - c^2 / 4; x'' is the real part of (-c / 2 + i w)^2 e^((-c / 2 + i w) t).
host_sim::Record decay(double rate_Hz, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double rate = 0.5 * kViscous_N_s_m, omega = std::sqrt(kStiffness_N_m - rate * rate);
  host_sim::Record record;
  record.file = "decay.csv", record.sample_period_s = 1 / rate_Hz;
  record.channels = {{"acceleration_1_m_s2", host_sim::Quantity::kAcceleration, 1, {}}};
  for (int k = 0; k < static_cast<int>(6 * rate_Hz); ++k) {
    const double t = k / rate_Hz, envelope = std::exp(-rate * t);
    const double a =
        envelope * ((rate * rate - omega * omega) * std::cos(omega * t) + 2 * rate * omega * std::sin(omega * t));
    record.channels[0].values.push_back(0.01 * (a + 20 * normal(random)));
  }
  return record;
}

// Friction is asked for, as in the quickstart's rig file. Integrated twice the noise was the larger part of the displacement, the spring
// started at a sixth of its size, and dry friction held it there: "cannot describe", or an end stop.
TEST(NoisyDecay, WithFrictionAskedForItIsStillADecayingSine) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 1;
  rig.links[0].a = 1;
  rig.links[0].stiffness_N_m.estimate = rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  for (double rate_Hz : {19.4, 20.0, 21.0, 25.0})
    for (uint64_t seed : {1u, 2u, 3u}) {
      const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {decay(rate_Hz, seed)}, {});
      EXPECT_EQ(said(d), "none") << rate_Hz << " Hz, seed " << seed;
      EXPECT_NEAR(value_of(d.baseline, "stiffness[1-0]"), kStiffness_N_m, 0.03 * kStiffness_N_m);
      EXPECT_NEAR(value_of(d.baseline, "viscous[1-0]"), kViscous_N_s_m, 0.5 * kViscous_N_s_m);
    }
}

}  // namespace

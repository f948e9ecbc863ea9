// A rig whose scale two numbers alone set: a decay by its displacement, mass and spring known, the mass a tenth too small in the rig file.
// Closed forms with noise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/diagnosis/numbers/parameter_status.hpp"
#include "two_masses.hpp"

namespace {

using namespace two_masses;

constexpr double kMass_kg = 4.4, kStiffness_N_m = 5000, kViscous_N_s_m = 3;

host_sim::Record decay(uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double rate = 0.5 * kViscous_N_s_m / kMass_kg, omega = std::sqrt(kStiffness_N_m / kMass_kg - rate * rate);
  host_sim::Record record;
  record.file = "decay.csv", record.sample_period_s = 2e-3;
  record.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}}};
  for (int k = 0; k < 3000; ++k) {
    const double t = k * 2e-3;
    record.channels[0].values.push_back(0.01 * std::exp(-rate * t) * std::cos(omega * t) + 2e-5 * normal(random));
  }
  return record;
}

// m x'' + c x' + k x = 0 holds as well for r m, r c and r k. With 4.0 kg for 4.4 the spring is 1.1 times too stiff and the damper is read as
// 3 / 1.1 = 2.73, or the mass is wrong and it is 3.
TEST(Scale, OfAMassAndASpringEitherMayBeWrong) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = 4;
  rig.links[0].a = 1;
  rig.links[0].stiffness_N_m.value = kStiffness_N_m, rig.links[0].viscous_N_s_m.estimate = true;
  for (uint64_t seed : {1u, 2u}) {
    const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {decay(seed)}, {});
    ASSERT_EQ(d.causes.size(), 1u) << said(d);
    EXPECT_EQ(d.verdict, diagnosis::Verdict::kAmbiguous);
    std::vector<std::string> effects = {d.causes[0].effect};
    for (const diagnosis::NamedPlace& p : d.ambiguous_with) effects.push_back(p.effect);
    for (const char* effect : {"mass_error", "stiffness_error"})
      EXPECT_NE(std::find(effects.begin(), effects.end(), effect), effects.end()) << effect << ": " << said(d);
    const diagnosis::Parameter damper = parameter_of(d.extended, "viscous[1-0]");
    EXPECT_NEAR(damper.value, d.causes[0].effect == "mass_error" ? 3 : 3 / 1.1, 0.05);
    EXPECT_STREQ(diagnosis::status_word(damper, true), "BIAS_SUSPECT");
  }
}

}  // namespace

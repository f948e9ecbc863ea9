// One mass on a table that shakes: what is said of its mass, which no force weighs.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "host_sim/diagnosis/diagnosis.hpp"

namespace {

constexpr double kTwoPi = 6.283185307179586, kStep_s = 2e-3;
constexpr double kMass_kg = 1.5, kStiffness_N_m = 4000, kViscous_N_s_m = 6;
constexpr int kSamples = 8000, kTones = 24;

using Complex = std::complex<double>;

rig_file::RigModel rig(double stated_kg) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.dofs[0].mass_kg.value = stated_kg;
  rig.links.resize(1), rig.links[0].a = 1, rig.links[0].b = rig_file::kBase;
  rig.links[0].stiffness_N_m.value = kStiffness_N_m, rig.links[0].viscous_N_s_m.estimate = true;
  return rig;
}

// Tones of 2 to 13.5 Hz; m a + c (v - v_b) + k (x - x_b) = 0 makes of each (k + j w c) / (k - w^2 m + j w c) times the table's.
host_sim::Record record() {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> phase(0, kTwoPi);
  std::normal_distribution<double> normal;
  std::vector<double> values[4];
  for (std::vector<double>& list : values) list.assign(kSamples, 0.0);
  for (int i = 0; i < kTones; ++i) {
    const double w = kTwoPi * (2 + 0.5 * i), start = phase(random);
    const Complex carried =
        Complex(kStiffness_N_m, w * kViscous_N_s_m) / Complex(kStiffness_N_m - w * w * kMass_kg, w * kViscous_N_s_m);
    for (int k = 0; k < kSamples; ++k) {
      const Complex table = std::polar(2e-4, w * k * kStep_s + start), mass = carried * table;
      const double all[] = {table.real(), -w * w * table.real(), mass.real(), -w * w * mass.real()};
      for (int c = 0; c < 4; ++c) values[c][static_cast<size_t>(k)] += all[c];
    }
  }
  host_sim::Record made;
  made.file = "table.csv", made.sample_period_s = kStep_s;
  const char* names[] = {"displacement_base_m", "acceleration_base_m_s2", "displacement_1_m", "acceleration_1_m_s2"};
  for (int c = 0; c < 4; ++c) {
    double square = 0;
    for (double y : values[c]) square += y * y;
    const double sigma = 0.005 * std::sqrt(square / kSamples);
    for (double& y : values[c]) y += sigma * normal(random);
    made.channels.push_back({names[c], c % 2 ? host_sim::Quantity::kAcceleration : host_sim::Quantity::kDisplacement,
                             c < 2 ? rig_file::kBase : 1, values[c]});
  }
  return made;
}

const diagnosis::DetectionLimit* limit_of(const diagnosis::Diagnosis& d, const std::string& effect) {
  for (const diagnosis::DetectionLimit& l : d.minimum_detectable)
    if (l.effect == effect && l.where != "link 1-0") return &l;
  return nullptr;
}

// Were the mass wrong by a share, the equation would be met by a spring that is wrong by the same share, and by no other: what shows the
// one shows the other.
TEST(MassOnBase, AWrongMassWouldBeSeenWhereAWrongSpringWould) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig(kMass_kg), {record()}, {});
  ASSERT_EQ(d.verdict, diagnosis::Verdict::kNone);
  const diagnosis::DetectionLimit *mass = limit_of(d, "mass_error"), *spring = limit_of(d, "stiffness_error");
  ASSERT_NE(mass, nullptr);
  ASSERT_NE(spring, nullptr);
  EXPECT_NEAR(mass->strength / kMass_kg, spring->strength / kStiffness_N_m, 0.3 * spring->strength / kStiffness_N_m);
}

// As it is: 5 % too large a mass is named or its rival.
TEST(MassOnBase, AWrongMassIsSeen) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig(1.05 * kMass_kg), {record()}, {});
  EXPECT_EQ(d.verdict, diagnosis::Verdict::kAmbiguous);
}

}  // namespace

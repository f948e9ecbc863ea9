// A drive of two masses on a spring of which friction holds the second: its encoder shows a step now and then. What is known of the
// first mass is told all the same, and the rig file is not said to be wrong.
#include <algorithm>
#include <cmath>

#include "host_sim/diagnosis/first_values/start.hpp"
#include "two_masses.hpp"

namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kRate_Hz = 1000, kDuration_s = 8, kStep_m_s = 4e-3;
constexpr int kFiner = 50;
constexpr double kMass_kg = 0.8, kViscous_N_s_m = 8, kCoulomb_N = 0.35, kSpring_N_m = 100;

double rounded(double v) { return kStep_m_s * std::nearbyint(v / kStep_m_s); }

// Friction takes what speed it can in a step, and no more: it holds.
host_sim::Record recorded() {
  std::vector<double> forces, first, second;
  double x = 0, v = 0;
  const double h = 1 / (kRate_Hz * kFiner);
  // tones that never repeat together: nor do the steps' errors
  const auto force = [](double t) { return 1.6 * std::sin(kTwoPi * 4 * t) + 1.6 * std::sin(kTwoPi * 9.27 * t + 1); };
  for (int k = 0; k < static_cast<int>(kRate_Hz * kDuration_s); ++k) {
    forces.push_back(force(k / kRate_Hz)), first.push_back(rounded(v));
    second.push_back(k % 20 == 0 ? kStep_m_s * (k % 40 == 0 ? 1 : -1) : 0);  // a twentieth of the samples, to and fro
    for (int i = 0; i < kFiner; ++i) {
      const double t = k / kRate_Hz + (i + 0.5) * h;
      x += 0.5 * h * v;
      v += h * (force(t) - kSpring_N_m * x - kViscous_N_s_m * v) / kMass_kg;
      v = std::copysign(std::max(0.0, std::abs(v) - h * kCoulomb_N / kMass_kg), v);
      x += 0.5 * h * v;
    }
  }
  host_sim::Record record;
  record.file = "held.csv", record.sample_period_s = 1 / kRate_Hz;
  record.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, forces},
                     {"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, first},
                     {"velocity_2_m_s", host_sim::Quantity::kVelocity, 2, second}};
  return record;
}

rig_file::RigModel nothing_known() {
  rig_file::RigModel rig;
  rig.dofs.resize(2), rig.links.resize(3);
  for (rig_file::Dof& dof : rig.dofs) dof.mass_kg.estimate = true;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[1].a = 2, rig.links[1].b = rig_file::kGround;
  rig.links[2].a = 1, rig.links[2].b = 2;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  rig.links[1].viscous_N_s_m.estimate = rig.links[1].coulomb_N.estimate = true;
  rig.links[2].stiffness_N_m.estimate = true;
  return rig;
}

// No force acts on the second mass and it does not move: nothing tells of its size. It starts like the first.
TEST(HeldMass, StartsLikeTheOthers) {
  const rig_file::RigModel rig = nothing_known();
  const diagnosis::System system = diagnosis::make_system(rig);
  const std::vector<diagnosis::runs::Prepared> records = diagnosis::runs::prepare_all(rig, {recorded()}, {});
  diagnosis::runs::Model model = diagnosis::runs::rig_as_given(system, records);
  diagnosis::runs::start_values(system, records, model);
  for (const diagnosis::runs::ModelTerm& t : model)
    if (t.term.kind == diagnosis::Kind::kMass) {
      EXPECT_GT(t.value, 0.1) << t.term.dof;
      EXPECT_LT(t.value, 10) << t.term.dof;
    }
}

TEST(HeldMass, HidesNothingOfTheOther) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(nothing_known(), {recorded()}, {});
  EXPECT_EQ(d.cannot_describe, "");
  EXPECT_TRUE(d.causes.empty()) << two_masses::said(d);
  const diagnosis::Parameter mass = two_masses::parameter_of(d.baseline, "mass[1]"),
                             friction = two_masses::parameter_of(d.baseline, "coulomb[1-0]");
  EXPECT_NEAR(mass.value, kMass_kg, 0.05 * kMass_kg);
  EXPECT_NEAR(friction.value, kCoulomb_N, 0.1 * kCoulomb_N);
  EXPECT_LT(std::abs(mass.value - kMass_kg), 4 * mass.std);
  EXPECT_LT(std::abs(friction.value - kCoulomb_N), 4 * friction.std);
}

}  // namespace

// Recordings whose steps are coarse for the motion.
#include <algorithm>
#include <cmath>

#include "two_masses.hpp"

namespace {

using namespace diagnosis;

constexpr double kRate_Hz = 100, kDuration_s = 150;

// A mass of 0.12 kg on a spring of 3 N/m (0.8 Hz) with a damper of 4 mN s/m, let go from 70 mm: after 130 s it swings by 8 mm. What is
// added to the spring's force is the test's.
template <typename Force>
host_sim::Record decay(double step_m, const Force& added_N) {
  host_sim::Record made;
  made.file = "decay.csv", made.sample_period_s = 1 / kRate_Hz;
  made.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}}};
  constexpr int kFiner = 10;
  const double h = 1 / (kRate_Hz * kFiner);
  double x = 0.07, v = 0;
  for (int i = 0; i < kFiner * static_cast<int>(kRate_Hz * kDuration_s); ++i) {
    if (i % kFiner == 0) made.channels[0].values.push_back(0.2 + step_m * std::round((x + 0.0013) / step_m));
    x += 0.5 * h * v;
    v += h * (-3 * x - 0.004 * v + added_N(x)) / 0.12;
    x += 0.5 * h * v;
  }
  return made;
}

rig_file::RigModel rig() {
  rig_file::RigModel made;
  made.dofs.resize(1), made.links.resize(1);
  made.dofs[0].mass_kg.value = 0.12;
  made.links[0].a = 1, made.links[0].b = rig_file::kGround;
  made.links[0].stiffness_N_m.estimate = made.links[0].viscous_N_s_m.estimate = true;
  return made;
}

// Steps of 10 mm are 2.9 mm rms, and the unseen end moves by 6 mm rms. What the steps lose of a slow motion repeats with it: lines that
// nothing drives, and nothing that the rig file lacks.
TEST(CoarseSteps, WhatStepsLoseIsNotTheRigs) {
  const Diagnosis d = diagnose(rig(), {decay(0.01, [](double) { return 0.0; })}, {});
  EXPECT_EQ(d.verdict, Verdict::kNone) << two_masses::said(d);
  const Parameter spring = two_masses::parameter_of(d.baseline, "stiffness[1-0]"),
                  damper = two_masses::parameter_of(d.baseline, "viscous[1-0]");
  EXPECT_NEAR(spring.value, 3, 3 * spring.std);
  EXPECT_NEAR(damper.value, 0.004, 3 * damper.std);
  EXPECT_TRUE(std::any_of(d.advice.begin(), d.advice.end(), [](const std::string& text) {
    return text.find("too small for the steps of its channel") != std::string::npos;
  }));
}

// A limit is a strength that a rig can have: 9e293 N of friction was told where the steps were all that is left. 0.1 N would stop
// this mass within two swings.
TEST(CoarseSteps, LimitsAreStrengthsThatARigCanHave) {
  const Diagnosis d = diagnose(rig(), {decay(0.01, [](double) { return 0.0; })}, {});
  bool any = false;
  for (const DetectionLimit& limit : d.minimum_detectable) {
    if (limit.effect != "missing_coulomb") continue;
    any = true;
    EXPECT_GT(limit.strength, 1e-6);
    EXPECT_LT(limit.strength, 0.1);
  }
  EXPECT_TRUE(any);
}

// The same steps hide no spring that hardens by a seventh at the start.
TEST(CoarseSteps, AHardeningSpringIsNamedBesideThem) {
  const Diagnosis d = diagnose(rig(), {decay(0.01, [](double x) { return -90 * x * x * x; })}, {});
  EXPECT_TRUE(d.names("cubic_stiffness", "link 1-0")) << two_masses::said(d);
}

}  // namespace

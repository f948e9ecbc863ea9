// A pendulum that swings for 130 periods on an encoder of 1200 steps: friction shows in its envelope alone, and an error of
// a thousandth in its frequency is half a radian at the end.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/diagnosis/diagnosis.hpp"

namespace {

using diagnosis::Diagnosis;
using diagnosis::Verdict;

constexpr double kGravity = 37.25, kViscous = 0.013, kCoulomb = 0.045;  // per unit inertia
constexpr double kRate_Hz = 100, kDuration_s = 136, kEncoder_rad = 2 * M_PI / 1200;

// u'' = -G sin u - g3 sin 3u - c u' - F sign u' from 1.5 rad, classical Runge-Kutta in steps of 2.5 ms, until it sticks: friction
// holds once it turns where gravity is less. Read in the encoder's steps.
host_sim::Record swing(double third_N_m) {
  const auto pull = [=](double u) { return kGravity * std::sin(u) + third_N_m * std::sin(3 * u); };
  const auto rate = [&](double u, double v) { return -pull(u) - kViscous * v - std::copysign(kCoulomb, v); };
  host_sim::Record record;
  record.file = "swing.csv", record.sample_period_s = 1 / kRate_Hz;
  record.channels.push_back({"angle_1_rad", host_sim::Quantity::kDisplacement, 1, {}});
  constexpr int kSteps = 4;
  const double h = 1 / kRate_Hz / kSteps;
  double u = 1.5, v = -1e-9;
  bool held = false;
  for (int i = 0; i < static_cast<int>(kDuration_s * kRate_Hz); ++i) {
    record.channels[0].values.push_back(std::round(u / kEncoder_rad) * kEncoder_rad);
    for (int k = 0; k < kSteps && !held; ++k) {
      const double before = v;
      const double a1 = rate(u, v), a2 = rate(u + h / 2 * v, v + h / 2 * a1),
                   a3 = rate(u + h / 2 * (v + h / 2 * a1), v + h / 2 * a2),
                   a4 = rate(u + h * (v + h / 2 * a2), v + h * a3);
      u += h * v + h * h / 6 * (a1 + a2 + a3), v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
      held = v * before < 0 && std::abs(pull(u)) < kCoulomb;
    }
  }
  return record;
}

Diagnosis diagnosed(double third_N_m) {
  return diagnosis::diagnose(
      rig_file::parse_rig("schema = \"rig/1\"\n[[dof]]\ninertia_kg_m2 = 1.0\n[[link]]\nbetween = [1, 0]\n"
                          "gravity_torque_N_m = \"estimate\"\nviscous_N_m_s_rad = \"estimate\"\n",
                          "rig.toml"),
      {swing(third_N_m)}, {}, {});
}

TEST(LongDecay, NamesDryFrictionToItsValue) {
  const Diagnosis d = diagnosed(0);
  EXPECT_EQ(d.verdict, Verdict::kExplained);
  ASSERT_EQ(d.causes.size(), 1u);
  EXPECT_EQ(d.causes[0].effect, "missing_coulomb");
  ASSERT_EQ(d.causes[0].parameters.size(), 1u);
  EXPECT_NEAR(d.causes[0].parameters[0].value, kCoulomb, 0.02 * kCoulomb);
  EXPECT_GT(d.gain[0], 10);
}

// With a force beside it, a thousandth of gravity's, that a cogging of a third of a turn is and nothing else: the friction is named all the
// same, and where the cogging is not, as what is sure of an answer that says that more is missing.
TEST(LongDecay, NamesDryFrictionBesideAHarmonicOfGravity) {
  for (const double third_N_m : {0.02, -0.05}) {
    const Diagnosis d = diagnosed(third_N_m);
    const auto cogging =
        std::find_if(d.causes.begin(), d.causes.end(), [](const diagnosis::Cause& c) { return c.effect == "cogging"; });
    if (cogging == d.causes.end())
      EXPECT_TRUE(d.verdict == Verdict::kAmbiguous || d.verdict == Verdict::kPartly) << third_N_m;
    else
      EXPECT_NEAR(std::abs(cogging->parameters.at(0).value), std::abs(third_N_m), 0.1 * std::abs(third_N_m));
    bool named = false;
    for (const diagnosis::Cause& c : d.causes)
      if (c.effect == "missing_coulomb") {
        named = true;
        for (const diagnosis::NamedPlace& r : c.rivals)
          EXPECT_EQ(r.effect, "stribeck") << third_N_m;  // dry friction too
        EXPECT_NEAR(c.parameters.at(0).value, kCoulomb, 0.15 * kCoulomb) << third_N_m;
      }
    EXPECT_TRUE(named) << third_N_m;
  }
}

}  // namespace

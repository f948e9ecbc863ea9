// Records of few periods whose law is nearly, not wholly, one of the vocabulary: two weak tests together name it, and the simplest
// that does as well is not one that leaves much more.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/diagnosis/answer/answer.hpp"
#include "host_sim/diagnosis/trial/attempt.hpp"
#include "host_sim/diagnosis/trial/merit.hpp"
#include "one_mass.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;
using namespace diagnosis::runs;

// Three windows fitted and one unseen, as long as each other.
Attempt tried(double error, double unseen, int complexity) {
  Attempt a;
  a.state.fit.ok = true, a.error = error, a.unseen = unseen, a.complexity = complexity;
  a.candidates.resize(1);
  for (std::vector<Window>* windows : {&a.state.seen, &a.state.unseen}) {
    windows->resize(windows == &a.state.seen ? 3 : 1);
    for (Window& w : *windows) w.length = 100;
  }
  return a;
}

// It takes 0.4 of what is left on the windows fitted and half on the unseen ones; 2.4 and 2.5 deviations, each once in some 70, are
// together as rare as three.
TEST(FewPeriods, TwoTestsOfTwoDeviationsAreOneOfThree) {
  Attempt a = tried(0.6, 0.5, 1);
  a.z = 2.4, a.unseen_deviations = 2.5;
  EXPECT_TRUE(passes(a, 0, 0.01));
  EXPECT_FALSE(passes(a, 1, 0.01));  // beside another cause unseen windows repeat that one's error
  EXPECT_FALSE(passes(a, 0, 0.55));  // where most is noise, nothing need be missing at all
  a.z = 1.9;
  EXPECT_FALSE(passes(a, 0, 0.01));
  a.z = 3.1, a.unseen_deviations = 1.9;
  EXPECT_TRUE(passes(a, 0, 0.01));
  a.z = 2.4;
  EXPECT_FALSE(passes(a, 0, 0.01));
  a.unseen_deviations = 2.5, a.unseen = 0.75;  // a quarter of the unseen is less than a cause has to take
  EXPECT_FALSE(passes(a, 0, 0.01));
}

// A loud start shows a pitch that nothing here explains, the quiet end a damping law: of that it takes 0.88 at 4.5 deviations, of the start 0.06 at
// 3.6.
TEST(FewPeriods, WhatTakesNearlyAllOfUnseenWindowsIsNoChance) {
  Attempt a = tried(0.943, 0.119, 0);
  a.z = 3.57, a.unseen_deviations = 4.5;
  EXPECT_TRUE(passes(a, 0, 0.02));
  EXPECT_FALSE(passes(a, 1, 0.02));  // beside another cause unseen windows repeat that one's error
  a.unseen = 0.75;                   // a quarter is less than a cause has to take
  EXPECT_FALSE(passes(a, 0, 0.02));
  a.unseen = 0.119, a.unseen_deviations = 2.9;
  EXPECT_FALSE(passes(a, 0, 0.02));
  a.z = 2.9, a.unseen_deviations = 4.5;
  EXPECT_FALSE(passes(a, 0, 0.02));
}

// 0.75 of 0.34 and 0.25 of 0.42 are 0.36: 1.8 times 0.2. For one number more 1.5 times is much, for two 2.25 times.
TEST(FewPeriods, MuchMoreIsLeftByTheSimplerOne) {
  const Attempt simple = tried(0.34, 0.42, 0);
  EXPECT_TRUE(leaves_much_more(simple, tried(0.2, 0.2, 1), 0.01));
  EXPECT_FALSE(leaves_much_more(simple, tried(0.2, 0.2, 2), 0.01));
  EXPECT_FALSE(leaves_much_more(simple, tried(0.25, 0.25, 1), 0.01));  // 1.44 times
  EXPECT_FALSE(leaves_much_more(simple, tried(0.2, 0.2, 1), 0.3));     // both are near noise
}

// 7 periods of 25 mm at 0.5 Hz, swelling over 4 s and fading over 3 s; a play of 1 mm to each side, and behind it friction of 12 kN
// whose bristles bend over 5 mm. The play is no term of the vocabulary; a spring follows the small cycles as well.
host_sim::Record banded_damper(uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  host_sim::Record r;
  r.file = "damper.csv", r.sample_period_s = 1.0 / 512;
  std::vector<double> x, f;
  double y = 0, z = 0;
  for (int i = 0; i < 14 * 512; ++i) {
    const double t = i * r.sample_period_s;
    x.push_back(0.025 * std::min(1.0, t / 4) * std::min(1.0, (14 - t) / 3) * std::sin(3.14159265358979 * t));
    const double before = y;
    y = std::clamp(y, x.back() - 1e-3, x.back() + 1e-3);
    const double moved = y - before;
    z = std::clamp(z + moved / 5e-3 * (1 - (moved > 0 ? z : -z)), -1.0, 1.0);
    f.push_back(12e3 * z + 50 * normal(random));
  }
  r.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x},
                {"force_1_N", host_sim::Quantity::kForce, 1, f}};
  return r;
}

TEST(FewPeriods, OfAFrictionDamperWithPlayNameItsHysteresis) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  for (const uint64_t seed : {1u, 2u, 3u}) {
    const Diagnosis d = diagnose(rig, {banded_damper(seed)}, {});
    ASSERT_FALSE(d.causes.empty()) << two_masses::said(d);
    EXPECT_EQ(d.causes[0].effect, "presliding_hysteresis") << two_masses::said(d);
    EXPECT_GT(d.gain[0], 2.5) << two_masses::said(d);  // a spring: 1.6
  }
}

// Every sample is nought (a sensor that is not plugged in, with --anyway): there is no period to count windows in, and no end to halving them.
TEST(FewPeriods, NothingMoves) {
  const std::vector<double> nothing(2000, 0.0);
  host_sim::Record record;
  record.file = "still.csv", record.sample_period_s = 1e-3;
  record.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, nothing}};
  EXPECT_THROW(diagnosis::diagnose(one_mass::rig(), {record}, {}, {}), diagnosis::CannotAnswer);
}

}  // namespace

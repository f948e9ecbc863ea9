// Forces that a damper takes on a crank, where the crank turns round. Closed forms.
#include "host_sim/diagnosis/fit/reversals.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/doubts/possible.hpp"
#include "host_sim/diagnosis/motion/guess.hpp"
#include "host_sim/diagnosis/unseen/error_sums.hpp"
#include "two_masses.hpp"

namespace {

using diagnosis::runs::Vec;

rig_file::RigModel damper() {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1;
  rig.links[0].stiffness_N_m.estimate = rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  return rig;
}

// Rates of -3 -1 1 3 5 3 1 -1 -3 at one-second steps, rms 2.6, measured without noise: from sample to sample they change by 2, but by half of
// that around the crest, whose two neighbours are alike. Within 1 (the rates of +-1) the next sample may be beyond the reversal.
TEST(Reversals, AreWhereTheNextSampleMayBeBeyondOne) {
  diagnosis::runs::Prepared record;
  record.samples = 9, record.step_s = 1, record.smooth_half = 2;
  record.force.resize(1);
  record.guess.resize(2);
  record.guess[0].given = true;
  record.guess[0].v.resize(9);
  record.guess[0].v << -3, -1, 1, 3, 5, 3, 1, -1, -3;
  const diagnosis::System system = diagnosis::make_system(damper());
  const diagnosis::runs::Mat known = diagnosis::runs::directions_known(system, record);
  ASSERT_EQ(known.rows(), 1);
  Vec expected(9);
  expected << 1, 0, 0, 1, 1, 1, 0, 0, 1;
  EXPECT_EQ(Vec(known.row(0)), expected) << known;
}

// A cubic over five samples: s2 = 10, s4 = 34, s6 = 130, and a slope's variance is s6 / (s2 s6 - s4^2) = 130 / 144 of the reading's.
TEST(Reversals, NoiseOfASlope) { EXPECT_NEAR(diagnosis::runs::slope_noise(2, 0.5), 2 * std::sqrt(130.0 / 144), 1e-12); }

// 827 N s/m, 13.6 N and 1830 N/m at one frequency and level; the displacement has noise of 1/5000 of its amplitude, the force of 0.5 N.
host_sim::Record on_a_crank(double rate_Hz, unsigned seed) {
  constexpr double kAmplitude_m = 0.004, kOmega = 2 * M_PI * 1.37;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> force, place;
  for (int k = 0; k < static_cast<int>(20 * rate_Hz); ++k) {
    const double phase = kOmega * k / rate_Hz, x = kAmplitude_m * std::sin(phase),
                 v = kAmplitude_m * kOmega * std::cos(phase);
    force.push_back(1830 * x + 827 * v + std::copysign(13.6, v) + 0.5 * normal(random));
    place.push_back(x + kAmplitude_m / 5000 * normal(random));
  }
  host_sim::Record made;
  made.file = "tester.csv", made.sample_period_s = 1 / rate_Hz;
  made.channels = {{"force_1_N", host_sim::Quantity::kForce, 1, force},
                   {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, place}};
  return made;
}

// At a few samples friction had the wrong sign, or half of it: a Stribeck of ten times the friction that ends at a thousandth of the
// rate patched them, and was `explained`.
TEST(Reversals, FrictionThatJumpsThereIsNoOtherLaw) {
  for (const double rate_Hz : {100.0, 300.0, 1000.0})
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const diagnosis::Diagnosis d = diagnosis::diagnose(damper(), {on_a_crank(rate_Hz, seed)}, {});
      EXPECT_EQ(d.verdict, diagnosis::Verdict::kNone) << rate_Hz << ' ' << seed << two_masses::said(d);
      EXPECT_NEAR(two_masses::value_of(d.baseline, "coulomb[1-0]"), 13.6, 0.2);
      EXPECT_NEAR(two_masses::value_of(d.baseline, "viscous[1-0]"), 827, 6);
    }
}

// Two records of an encoder that counts on, +-1 about 10 and +-2 about -30, missed by 0.1 all along: the mean square of the motion is
// (1 + 4) / 2, not that about the mean of both, which is some hundreds. Of the second record one sample is not counted.
TEST(ErrorSums, EveryRecordHasItsOwnMean) {
  diagnosis::runs::ErrorSums sums;
  Vec first(4), second(5);
  first << 9, 11, 9, 11;
  second << -32, -28, -32, -28, 500;
  Vec counted = Vec::Ones(5);
  counted[4] = 0;
  sums.add(first.array() + 0.1, first);
  sums.end_record();
  sums.add(second.array() + 0.1, second, counted);
  sums.end_record();
  EXPECT_DOUBLE_EQ(sums.variance(), 2.5);
  EXPECT_NEAR(sums.ratio(), 0.01 / 2.5, 1e-12);
}

// A force that reads r times itself: its own number is 1 - 1 / r.
TEST(ImpossibleGain, IsOneThatNoSensorHas) {
  diagnosis::runs::Candidate gain;
  gain.terms = {diagnosis::on_dof(diagnosis::Kind::kForceGain, 0)};
  diagnosis::runs::State with;
  with.model.resize(1);
  with.model[0].term = gain.terms[0];
  const auto is = [&](double reads) {
    with.model[0].value = 1 - 1 / reads;
    return diagnosis::runs::is_no_sensors(with, {gain});
  };
  for (const double reads : {0.001, 0.9, 1.2, 9.81, 1000.0, -1.0}) EXPECT_FALSE(is(reads)) << reads;
  for (const double reads : {-15400.0, -5.0, 1e5, 1e-5}) EXPECT_TRUE(is(reads)) << reads;
}

}  // namespace

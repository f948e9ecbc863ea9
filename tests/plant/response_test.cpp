// Simulated motion against solutions worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/plant/motion/simulate.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "tests/plant/rigs.hpp"

namespace {

using host_sim::Quantity;
using plant_test::effect;
using plant_test::oscillator;
constexpr double kPi = 3.14159265358979323846;

host_sim::Record run(const rig_file::RigModel& rig, double x0, double v0, size_t count, double period = 1e-3,
                     const host_sim::Excitation& excitation = {}, host_sim::IntegratorOptions options = {}) {
  return host_sim::simulate(rig, {{x0}, {v0}}, excitation, {period, 0, 0, count}, options);
}
const std::vector<double>& channel(const host_sim::Record& record, Quantity quantity, int dof = 1) {
  return record.find(quantity, dof)->values;
}

// m = 1, k = 400: x = 0.01 cos 20 t.
TEST(Response, UndampedOscillatorIsACosine) {
  const auto record = run(oscillator(1.0, 400.0), 0.01, 0.0, 10001);
  for (size_t i = 0; i < 10001; i += 100) {
    const double phase = 20.0 * 1e-3 * static_cast<double>(i);
    EXPECT_NEAR(channel(record, Quantity::kDisplacement)[i], 0.01 * std::cos(phase), 1e-2 * 1e-7);
    EXPECT_NEAR(channel(record, Quantity::kVelocity)[i], -0.2 * std::sin(phase), 0.2 * 1e-7);
    EXPECT_NEAR(channel(record, Quantity::kAcceleration)[i], -4.0 * std::cos(phase), 4.0 * 1e-7);
  }
}

// m = 1, k = 400, c = 2: x = e^-t (cos wd t + sin(wd t) / wd), wd = sqrt(399), for x0 = 1, v0 = 0.
TEST(Response, ViscousDecayHasItsEnvelope) {
  for (const auto method :
       {host_sim::Method::kFehlberg8, host_sim::Method::kDormandPrince5, host_sim::Method::kBogackiShampine3}) {
    const auto record = run(oscillator(1.0, 400.0, 2.0), 1.0, 0.0, 3001, 1e-3, {}, {method, 1e-9, 200000});
    const double wd = std::sqrt(399.0);
    for (size_t i = 0; i < 3001; i += 50) {
      const double t = 1e-3 * static_cast<double>(i);
      EXPECT_NEAR(channel(record, Quantity::kDisplacement)[i],
                  std::exp(-t) * (std::cos(wd * t) + std::sin(wd * t) / wd), 2e-7);
    }
  }
}

// m = 1, k = 100 (w = 10, half period pi/10), F = 1: each half period is a cosine about +-F/k = 0.01, so the turning
// points are 0.095, -0.075, 0.055, -0.035, 0.015, then x = +0.005 where k|x| = 0.5 < F: stuck for good (amplitude drops
// 4F/k = 0.04 per cycle). |0.015 - 0.01| = 0.005 is the last half swing: from 0.015 to 0.005.
TEST(Response, CoulombDecayDropsLinearlyAndSticks) {
  const double half = kPi / 10.0;
  const auto record = run(oscillator(1.0, 100.0, 0.0, 1.0), 0.095, 0.0, 2001, half / 200.0);
  const double turning[] = {0.095, -0.075, 0.055, -0.035, 0.015};
  for (size_t k = 0; k < 5; ++k) EXPECT_NEAR(channel(record, Quantity::kDisplacement)[200 * k], turning[k], 1e-9) << k;
  // The last swing starts at 0.015: k x = 1.5 > F = 1, about +0.01, to 0.005.
  for (size_t i = 1000; i < 2001; ++i) {
    EXPECT_NEAR(channel(record, Quantity::kDisplacement)[i], 0.005, 1e-9);
    if (i > 1000) {
      EXPECT_EQ(channel(record, Quantity::kVelocity)[i], 0.0);
      EXPECT_EQ(channel(record, Quantity::kAcceleration)[i], 0.0);
    }
  }
}

// Within the first half swing: x = 0.01 + 0.085 cos 10 t.
TEST(Response, CoulombSwingIsACosineAboutTheShiftedCentre) {
  const auto record = run(oscillator(1.0, 100.0, 0.0, 1.0), 0.095, 0.0, 300);
  for (size_t i = 0; i < 300; i += 10)
    EXPECT_NEAR(channel(record, Quantity::kDisplacement)[i], 0.01 + 0.085 * std::cos(0.01 * static_cast<double>(i)),
                1e-9);
}

// A body of 2 kg at rest, F = 3, force 5 sin(2 pi t) N (cosine of phase -pi/2): lets go at sin = 0.6, t = asin(0.6) / 2
// pi; then 2 v = integral of 5 sin - 3.
TEST(Response, HeldBodyLetsGoWhenTheForceExceedsTheLevel) {
  host_sim::Excitation excitation;
  excitation.force_N = {host_sim::cosine(5.0, 1.0, -kPi / 2)};
  const auto record = run(oscillator(2.0, 0.0, 0.0, 3.0), 0.0, 0.0, 251, 1e-3, excitation);
  const double release = std::asin(0.6) / (2 * kPi);
  for (size_t i = 0; i < 251; ++i) {
    const double t = 1e-3 * static_cast<double>(i);
    const double v = t <= release ? 0.0 : (5.0 / (2 * kPi) * (0.8 - std::cos(2 * kPi * t)) - 3.0 * (t - release)) / 2.0;
    EXPECT_NEAR(channel(record, Quantity::kVelocity)[i], v, 1e-10) << i;
    if (t < release) {
      EXPECT_EQ(channel(record, Quantity::kVelocity)[i], 0.0);
    }
  }
}

// Two bodies of 1 kg, held to each other by F12 = 2 and body 2 to the ground by F20 = 1. Force f on body 1, constant.
// f = 0.9: all held. f = 2: body 2 slides with body 1 stuck to it: a = (2 - 1) / 2 = 0.5 each (link 1-2 carries 1.5 <
// 2). f = 4: both slide: body 1 (4 - 2) / 1 = 2, body 2 (2 - 1) / 1 = 1.
TEST(Response, SeveralLinksStickAtOnce) {
  rig_file::RigModel rig = oscillator(1.0, 0.0, 0.0, 2.0);
  rig.dofs.push_back(rig.dofs[0]);
  rig.links[0].b = 2;
  rig.links.push_back(rig.links[0]);
  rig.links[1].a = 2;
  rig.links[1].b = 0;
  rig.links[1].coulomb_N.value = 1.0;
  const double force[] = {0.9, 2.0, 4.0}, a1[] = {0.0, 0.5, 2.0}, a2[] = {0.0, 0.5, 1.0};
  for (int k = 0; k < 3; ++k) {
    host_sim::Excitation excitation;
    excitation.force_N = {host_sim::cosine(force[k], 0.0), nullptr};
    const auto record = run(rig, 0.0, 0.0, 101, 1e-3, excitation);
    EXPECT_NEAR(channel(record, Quantity::kAcceleration, 1)[100], a1[k], 1e-12);
    EXPECT_NEAR(channel(record, Quantity::kAcceleration, 2)[100], a2[k], 1e-12);
    EXPECT_NEAR(channel(record, Quantity::kVelocity, 1)[100], 0.1 * a1[k], 1e-10);
    if (k == 1) {
      EXPECT_EQ(channel(record, Quantity::kVelocity, 1)[100], channel(record, Quantity::kVelocity, 2)[100]);
    }
  }
}

// Base excitation of m = 1, k = 100, c = 4 (zeta = 0.2) at r = w / wn = 2: |X/Y|^2 = (1 + (2 zeta r)^2) / ((1 - r^2)^2
// + (2 zeta r)^2) = 1.64 / 9.64. After 10 s the transient e^-20 is gone.
TEST(Response, BaseExcitationHasTheTextbookTransmissibility) {
  host_sim::Excitation excitation;
  excitation.base_m = host_sim::cosine(0.01, 20.0 / (2 * kPi));
  const auto record = run(oscillator(1.0, 100.0, 4.0, 0.0, rig_file::kBase), 0.0, 0.0, 11001, 1e-3, excitation);
  double largest = 0.0;
  for (size_t i = 10000; i < 11001; ++i)
    largest = std::max(largest, std::fabs(channel(record, Quantity::kDisplacement)[i]));
  EXPECT_NEAR(largest / (0.01 * std::sqrt(1.64 / 9.64)), 1.0,
              5e-5);  // a sample may miss the crest by half a millisecond
  EXPECT_DOUBLE_EQ(record.find(Quantity::kVelocity, rig_file::kBase)->values[0], 0.0);
}

// Stuck to a moving base: the body moves exactly as the base does (m a_peak = 1 * 0.001 * 400 = 0.4 N < F = 1 N).
TEST(Response, BodyHeldByTheBaseMovesWithIt) {
  host_sim::Excitation excitation;
  excitation.base_m = host_sim::cosine(0.001, 20.0 / (2 * kPi));
  const auto record = run(oscillator(1.0, 0.0, 0.0, 1.0, rig_file::kBase), 0.001, 0.0, 1001, 1e-3, excitation);
  for (size_t i = 0; i < 1001; ++i) {
    EXPECT_EQ(channel(record, Quantity::kVelocity)[i], record.find(Quantity::kVelocity, rig_file::kBase)->values[i]);
    EXPECT_NEAR(channel(record, Quantity::kDisplacement)[i],
                record.find(Quantity::kDisplacement, rig_file::kBase)->values[i], 1e-11);
  }
}

TEST(Response, CoefficientsToBeEstimatedAndBodiesWithoutMassAreRefused) {
  rig_file::RigModel rig = oscillator(1.0, 1.0);
  rig.links[0].viscous_N_s_m.estimate = true;
  try {
    run(rig, 0, 0, 2);
    FAIL();
  } catch (const host_sim::PlantError& error) {
    EXPECT_NE(std::string(error.what()).find("viscous[1-0]"), std::string::npos) << error.what();
  }
  try {
    run(oscillator(0.0, 1.0), 0, 0, 2);
    FAIL();
  } catch (const host_sim::PlantError& error) {
    EXPECT_NE(std::string(error.what()).find("mass[1]"), std::string::npos) << error.what();
  }
}

}  // namespace

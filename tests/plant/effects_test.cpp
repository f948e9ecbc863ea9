// Every effect of the vocabulary against a motion worked out by hand. Unless said otherwise m = 1 kg and nothing else
// acts.
#include <gtest/gtest.h>

#include <cmath>

#include "host_sim/plant/motion/simulate.hpp"
#include "host_sim/plant/plant_error.hpp"
#include "tests/plant/rigs.hpp"

namespace {

using host_sim::Quantity;
using plant_test::effect;
using plant_test::oscillator;

struct Motion {
  std::vector<double> x, v, a;
};

Motion run(const rig_file::RigModel& rig, double x0, double v0, size_t count, double constant_force = 0.0) {
  host_sim::Excitation excitation;
  if (constant_force != 0.0) excitation.force_N = {host_sim::cosine(constant_force, 0.0)};
  const auto record = host_sim::simulate(rig, {{x0}, {v0}}, excitation, {1e-3, 0, 0, count, 0.0});
  return {record.find(Quantity::kDisplacement, 1)->values, record.find(Quantity::kVelocity, 1)->values,
          record.find(Quantity::kAcceleration, 1)->values};
}

rig_file::RigModel with(const rig_file::Effect& added, double k = 0.0, double c = 0.0) {
  rig_file::RigModel rig = oscillator(1.0, k, c);
  rig.links[0].effects.push_back(added);
  return rig;
}

// Energy v^2 / 2 + k3 x^4 / 4 stays that of the release at 0.1 m: 1e4 * 1e-4 / 4 = 0.25 J.
TEST(Effects, CubicStiffnessStoresAQuarterOfTheFourthPower) {
  const Motion m = run(with(effect("cubic_stiffness", 1e4)), 0.1, 0.0, 1001);
  for (size_t i = 0; i < 1001; ++i) EXPECT_NEAR(0.5 * m.v[i] * m.v[i] + 2500.0 * std::pow(m.x[i], 4), 0.25, 1e-9);
}

// v^2 / 2 + 100 x^2 / 2 + 300 x^3 / 3 = 0.5 * 100 * 0.01 + 0.1 = 0.6 J.
TEST(Effects, QuadraticStiffnessStoresAThirdOfTheCube) {
  const Motion m = run(with(effect("quadratic_stiffness", 300.0), 100.0), 0.1, 0.0, 1001);
  for (size_t i = 0; i < 1001; ++i)
    EXPECT_NEAR(0.5 * m.v[i] * m.v[i] + 50.0 * m.x[i] * m.x[i] + 100.0 * std::pow(m.x[i], 3), 0.6, 1e-9);
}

// k = 400 (w = 20) beyond +-0.01 m, v0 = 0.1 from the middle: 0.1 s at constant speed, half a sine pi/20 s long of
// height 0.1 / 20 = 0.005 m, back at the same speed. An end stop of 400 N/m does the same without any k.
TEST(Effects, BacklashAndEndStopLeaveTheGapFree) {
  const rig_file::RigModel rigs[] = {with(effect("backlash", 400.0, "gap_m", 0.01), 400.0),
                                     with(effect("end_stop", 400.0, "gap_m", 0.01))};
  for (const rig_file::RigModel& rig : rigs) {
    const Motion m = run(rig, 0.0, 0.1, 601);
    const double contact = 3.14159265358979323846 / 20.0;
    for (size_t i = 0; i < 601; ++i) {
      const double t = 1e-3 * static_cast<double>(i);
      double x = 0.1 * t;
      if (t > 0.1) x = 0.01 + 0.005 * std::sin(20.0 * (t - 0.1));
      if (t > 0.1 + contact) x = 0.01 - 0.1 * (t - 0.1 - contact);
      if (t > 0.3 + contact) x = -0.01 - 0.005 * std::sin(20.0 * (t - 0.3 - contact));
      if (t > 0.3 + 2 * contact) break;
      EXPECT_NEAR(m.x[i], x, 1e-10) << i;
    }
  }
}

// v' = -c2 v^2: v = v0 / (1 + c2 v0 t).
TEST(Effects, QuadraticDamping) {
  const Motion m = run(with(effect("quadratic_damping", 3.0)), 0.0, -2.0, 1001);
  for (size_t i = 0; i < 1001; ++i) EXPECT_NEAR(m.v[i], -2.0 / (1.0 + 6e-3 * static_cast<double>(i)), 1e-9);
}

// v' = -c3 v^3: v = v0 / sqrt(1 + 2 c3 v0^2 t).
TEST(Effects, CubicDamping) {
  const Motion m = run(with(effect("cubic_damping", 3.0)), 0.0, 2.0, 1001);
  for (size_t i = 0; i < 1001; ++i) EXPECT_NEAR(m.v[i], 2.0 / std::sqrt(1.0 + 24e-3 * static_cast<double>(i)), 1e-9);
}

// v' = -Fs exp(-v / vs): exp(v / vs) falls by Fs / vs per second. Fs = 2, vs = 0.5, v0 = 0.5: e - 4 t, rest at t = (e -
// 1) / 4.
TEST(Effects, StribeckStopsAndHolds) {
  const Motion m = run(with(effect("stribeck", 2.0, "stribeck_velocity_m_s", 0.5)), 0.0, 0.5, 601);
  const double rest_s = (std::exp(1.0) - 1.0) / 4.0;
  for (size_t i = 0; i < 601; ++i) {
    const double t = 1e-3 * static_cast<double>(i);
    if (t > rest_s) {
      EXPECT_EQ(m.v[i], 0.0);
    } else {
      EXPECT_NEAR(m.v[i], 0.5 * std::log(std::exp(1.0) - 4.0 * t), 1e-9);
    }
  }
}

// From rest under f = 3 N against Dahl friction of 2 N, length d = 0.01 m: z = 1 - exp(-x / d), so
// v^2 / 2 = f x - F (x - d (1 - exp(-x / d))).
TEST(Effects, PreslidingHysteresisBuildsUpOverItsLength) {
  const Motion m = run(with(effect("presliding_hysteresis", 2.0, "presliding_length_m", 0.01)), 0.0, 0.0, 501, 3.0);
  for (size_t i = 0; i < 501; ++i) {
    const double x = m.x[i];
    EXPECT_NEAR(0.5 * m.v[i] * m.v[i], 3.0 * x - 2.0 * (x + 0.01 * std::expm1(-x / 0.01)), 1e-9);
  }
  EXPECT_GT(m.x[500], 0.1);
}

// k = 100, F0 = 5, from rest at 0: x = -0.05 (1 - cos 10 t).
TEST(Effects, ForceOffsetShiftsTheCentre) {
  const Motion m = run(with(effect("force_offset", 5.0), 100.0), 0.0, 0.0, 1001);
  for (size_t i = 0; i < 1001; ++i) EXPECT_NEAR(m.x[i], -0.05 * (1.0 - std::cos(1e-2 * static_cast<double>(i))), 1e-10);
}

// c = 2, c_a = 0.5: decay rate 2.5 forwards, 1.5 backwards.
TEST(Effects, AsymmetricViscousDependsOnDirection) {
  const rig_file::RigModel rig = with(effect("asymmetric_viscous", 0.5), 0.0, 2.0);
  EXPECT_NEAR(run(rig, 0.0, 1.0, 1001).v[1000], std::exp(-2.5), 1e-10);
  EXPECT_NEAR(run(rig, 0.0, -1.0, 1001).v[1000], -std::exp(-1.5), 1e-10);
}

// v' = -c_u x^2 v, so v = v0 - c_u x^3 / 3.
TEST(Effects, DisplacementDependentDamping) {
  const Motion m = run(with(effect("displacement_dependent_damping", 30.0)), 0.0, 1.0, 1001);
  for (size_t i = 0; i < 1001; ++i) EXPECT_NEAR(m.v[i], 1.0 - 10.0 * std::pow(m.x[i], 3), 1e-10);
  EXPECT_LT(m.v[1000], 0.5);
}

// v' = -c_t t v: v = v0 exp(-c_t t^2 / 2).
TEST(Effects, DriftingViscousGrowsWithTime) {
  const Motion m = run(with(effect("drifting_viscous", 2.0)), 0.0, 1.0, 1001);
  for (size_t i = 0; i < 1001; ++i) EXPECT_NEAR(m.v[i], std::exp(-1e-6 * static_cast<double>(i * i)), 1e-10);
}

// v' = -c_t tau (1 - exp(-t / tau)) v: v = exp(-c_t tau (t - tau (1 - exp(-t / tau)))).
TEST(Effects, DriftingViscousLevelsOff) {
  const Motion m = run(with(effect("drifting_viscous", 2.0, "drift_time_s", 0.25)), 0.0, 1.0, 1001);
  for (size_t i = 0; i < 1001; ++i) {
    const double t = 1e-3 * static_cast<double>(i);
    EXPECT_NEAR(m.v[i], std::exp(-0.5 * (t - 0.25 * (1 - std::exp(-4 * t)))), 1e-10);
  }
}

// Pendulum of J = 2, G = 20, released at 2 rad: v^2 - 20 cos u stays -20 cos 2.
TEST(Effects, GravityTorqueIsThatOfAPendulum) {
  rig_file::RigModel rig = oscillator(2.0, 0.0);
  rig.dofs[0].rotating = true;
  rig.links[0].gravity_torque_N_m.value = 20.0;
  const Motion m = run(rig, 2.0, 0.0, 3001);
  for (size_t i = 0; i < 3001; ++i) EXPECT_NEAR(m.v[i] * m.v[i] - 20.0 * std::cos(m.x[i]), -20.0 * std::cos(2.0), 1e-8);
}

// Hidden 0.5 kg at f_h = 2 Hz on a free body of 1 kg, force 3 N from rest. With W^2 = (2 pi 2)^2 (1 + 0.5) the bodies
// part by s = 3 / W^2 (1 - cos W t); the body is at 3 t^2 / (2 * 1.5) + s / 3.
TEST(Effects, UnmodelledResonanceIsAHiddenMassOnASpring) {
  rig_file::RigModel rig = oscillator(1.0, 0.0);
  rig.dofs[0].effects.push_back(effect("unmodelled_resonance", 0.5, "resonance_Hz", 2.0));
  const Motion m = run(rig, 0.0, 0.0, 1001, 3.0);
  const double big_w = 4.0 * 3.14159265358979323846 * std::sqrt(1.5);
  for (size_t i = 0; i < 1001; ++i) {
    const double t = 1e-3 * static_cast<double>(i);
    EXPECT_NEAR(m.x[i], t * t + (1.0 - std::cos(big_w * t)) / (big_w * big_w), 1e-10);
  }
}

// m = 1, released at rest 0.3 m away in a force 2 sin(2 pi x / 0.5 + 1): the energy is v^2 / 2 - 2 * 0.5 / (2 pi)
// cos(2 pi x / 0.5 + 1).
TEST(Effects, CoggingGivesBackWhatItTakes) {
  rig_file::Effect cogging = effect("cogging", 2.0, "pitch_m", 0.5);
  cogging.shape["phase_rad"] = 1.0;
  const Motion m = run(with(cogging), 0.3, 0.0, 2001);
  const double two_pi = 2.0 * 3.14159265358979323846;
  const auto energy = [&](size_t i) {
    return 0.5 * m.v[i] * m.v[i] - 1.0 / two_pi * std::cos(two_pi * m.x[i] / 0.5 + 1.0);
  };
  for (size_t i = 0; i < 2001; ++i) EXPECT_NEAR(energy(i), energy(0), 1e-9);
  EXPECT_GT(std::fabs(m.x[1000] - 0.3), 0.01);
}

// A drive with a dead band of 2 N that is asked for 5 N pushes with 3 N, asked for 1 N not at all.
TEST(Effects, ADeadBandOfTheDriveTakesItsBand) {
  rig_file::RigModel rig = oscillator(1.0, 0.0);
  rig.dofs[0].effects.push_back(effect("drive_dead_band", 1.0, "dead_band_N", 2.0));
  EXPECT_NEAR(run(rig, 0.0, 0.0, 1001, 5.0).v[1000], 3.0, 1e-9);
  EXPECT_NEAR(run(rig, 0.0, 0.0, 1001, -5.0).v[1000], -3.0, 1e-9);
  EXPECT_EQ(run(rig, 0.0, 0.0, 1001, 1.0).x[1000], 0.0);
}

// An unbalanced weight of 20 N m adds to one of 5 N m that the file has: J = 2, v^2 - 25 cos u stays.
TEST(Effects, AMissingGravityTorqueAddsToTheFiles) {
  rig_file::RigModel rig = oscillator(2.0, 0.0);
  rig.dofs[0].rotating = true;
  rig.links[0].gravity_torque_N_m.value = 5.0;
  rig.links[0].effects.push_back(effect("missing_gravity_torque", 20.0));
  const Motion m = run(rig, 2.0, 0.0, 1001);
  for (size_t i = 0; i < 1001; ++i) EXPECT_NEAR(m.v[i] * m.v[i] - 25.0 * std::cos(m.x[i]), -25.0 * std::cos(2.0), 1e-8);
}

// Terms named as errors of the rig file add to what is there: k 50 + 50, c 1 + 1, m 0.5 + 0.5 swing as m 1, k 100, c 2.
TEST(Effects, ErrorsAddToTheRigFilesTerms) {
  rig_file::RigModel rig = oscillator(0.5, 50.0, 1.0);
  rig.dofs[0].effects.push_back(effect("mass_error", 0.5));
  rig.links[0].effects = {effect("stiffness_error", 50.0), effect("missing_viscous", 1.0),
                          effect("missing_coulomb", 0.25)};
  const Motion a = run(rig, 0.1, 0.0, 1001), b = run(oscillator(1.0, 100.0, 2.0, 0.25), 0.1, 0.0, 1001);
  EXPECT_EQ(a.x, b.x);
}

TEST(Effects, AnEffectWithoutItsShapeIsRefused) {
  try {
    run(with(effect("end_stop", 1.0)), 0.0, 0.0, 2);
    FAIL();
  } catch (const host_sim::PlantError& error) {
    EXPECT_NE(std::string(error.what()).find("gap"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("end_stop[1-0]"), std::string::npos) << error.what();
  }
}

}  // namespace

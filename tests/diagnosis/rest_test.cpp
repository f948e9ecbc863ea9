// Records that are held before they are let go, dampers that are stopped: rest at both ends is no law of motion. And what
// repeats along the way has to be seen to repeat. The motions here are exact solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using two_masses::parameter_of;
using two_masses::said;
constexpr double kPi = 3.14159265358979;

// Of m x'' + c x' + F sign(x') + k x = 0, let go at x0: between reversals a damped cosine about +-F/k, half a damped period each;
// where the spring is no stronger than F it stays.
struct Decay {
  double mass = 2, stiffness = 1800, viscous = 3, coulomb = 0, let_go_at_s = 0, start_m = 0.02;
  double at(double t) const {
    const double sigma = viscous / (2 * mass), w = std::sqrt(stiffness / mass - sigma * sigma), half = kPi / w;
    double from = start_m, since = t - let_go_at_s;
    if (since <= 0) return from;
    for (;;) {
      if (std::abs(from) * stiffness <= coulomb) return from;
      const double middle = std::copysign(coulomb / stiffness, from);
      const auto swing = [&](double s) {
        return middle + (from - middle) * std::exp(-sigma * s) * (std::cos(w * s) + sigma / w * std::sin(w * s));
      };
      if (since <= half) return swing(since);
      from = swing(half), since -= half;
    }
  }
};

host_sim::Record record_of(double rate_Hz, const std::vector<double>& displacement, const std::vector<double>& force) {
  host_sim::Record r;
  r.file = "record.csv", r.sample_period_s = 1 / rate_Hz;
  r.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, displacement}};
  if (!force.empty()) r.channels.push_back({"force_1_N", host_sim::Quantity::kForce, 1, force});
  return r;
}

rig_file::RigModel one_mass(double mass_kg, double stiffness_N_m, bool friction) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = mass_kg;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m.value = stiffness_N_m;
  rig.links[0].viscous_N_s_m.estimate = true, rig.links[0].coulomb_N.estimate = friction;
  return rig;
}

diagnosis::Diagnosis of_decay(const Decay& plant, bool friction_listed) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> x;
  for (int i = 0; i < 8000; ++i) x.push_back(plant.at(i * 1e-3) + 1e-5 * normal(random));
  return diagnosis::diagnose(one_mass(plant.mass, plant.stiffness, friction_listed), {record_of(1000, x, {})}, {});
}

TEST(Rest, BeforeADecayIsLetGoIsLeftOut) {
  Decay plant;
  plant.coulomb = 0.4, plant.let_go_at_s = 1.2037;
  const diagnosis::Diagnosis d = of_decay(plant, true);
  EXPECT_EQ(said(d), "none");
  for (const auto& [name, truth] : {std::pair("viscous[1-0]", plant.viscous), std::pair("coulomb[1-0]", plant.coulomb)})
    EXPECT_NEAR(parameter_of(d.baseline, name).value, truth, 3 * parameter_of(d.baseline, name).std + 0.01 * truth)
        << name;
}

TEST(Rest, FrictionIsFoundInADecayThatWasHeldFirst) {
  Decay plant;
  plant.coulomb = 1.5, plant.let_go_at_s = 0.9;
  const diagnosis::Diagnosis d = of_decay(plant, false);
  EXPECT_EQ(said(d), "explained, missing_coulomb on link 1-0");
  EXPECT_NEAR(parameter_of(d.extended, "missing_coulomb[1-0]").value, plant.coulomb, 0.03 * plant.coulomb);
  EXPECT_NEAR(parameter_of(d.extended, "viscous[1-0]").value, plant.viscous, 0.05 * plant.viscous);
}

// Some eight swings in a third of a second, then rest to the eighth: noise of 2 % of the whole record's rms is 0.2 % of the swings. Its
// rates are larger than theirs over the record, and a taper over all of it would take the swings away.
struct ShortDecay {
  Decay plant{2, 16200, 8, 20, 0, 0.02};
  double noise_share = 0.02;
  diagnosis::Diagnosis answer() const {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    const double h = 1e-5;
    std::vector<double> x, a;
    for (int i = 0; i < 8000; ++i) {
      const double t = i * 1e-3 + 2 * h;
      x.push_back(plant.at(t)), a.push_back((plant.at(t + h) - 2 * plant.at(t) + plant.at(t - h)) / (h * h));
    }
    for (std::vector<double>* y : {&x, &a}) {
      double square = 0;
      for (double value : *y) square += value * value;
      for (double& value : *y) value += noise_share * std::sqrt(square / 8000) * normal(random);
    }
    host_sim::Record record = record_of(1000, x, {});
    record.channels.push_back({"acceleration_1_m_s2", host_sim::Quantity::kAcceleration, 1, a});
    return diagnosis::diagnose(one_mass(plant.mass, plant.stiffness, true), {record}, {});
  }
};

TEST(Rest, AfterAShortDecayHidesNothing) {
  const ShortDecay decay;
  const diagnosis::Diagnosis d = decay.answer();
  EXPECT_EQ(said(d), "none");
  for (const auto& [name, truth] :
       {std::pair("viscous[1-0]", decay.plant.viscous), std::pair("coulomb[1-0]", decay.plant.coulomb)}) {
    const diagnosis::Parameter p = parameter_of(d.baseline, name);
    EXPECT_NEAR(p.value, truth, 4 * p.std) << name;
    EXPECT_LT(p.std, 0.03 * truth) << name;
    EXPECT_FALSE(p.undetermined) << name;
  }
  EXPECT_LT(d.baseline.holdout_nrmse_percent.at(0), 5);
}

// A damper moved by 20 mm at 1 Hz: viscous, friction whose bristles bend over 0.5 mm (Dahl: along dx they go from z to
// s - (s - z) exp(-|dx| / length), s the direction), gas pressure. The crank stops at its farthest, 0.7 periods before the file ends, and the force
// creeps back to nought, as oil does and no law of friction.
struct Damper {
  double viscous = 1500, friction = 300, length_m = 0.0005, gas_N = -60, moved_s = 9.75, recorded_s = 10.45;
  double pitch_m = 0, cogging_N = 0;
  host_sim::Record record() const {
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    std::vector<double> x, f;
    double bristles = 0, last = 0;
    for (int i = 0; i < static_cast<int>(recorded_s * 300); ++i) {
      const double t = std::min(i / 300.0, moved_s), w = 2 * kPi;
      const double at = 0.02 * std::sin(w * t), rate = i / 300.0 < moved_s ? 0.02 * w * std::cos(w * t) : 0;
      const double direction = at > last ? 1 : -1;
      bristles = direction - (direction - bristles) * std::exp(-std::abs(at - last) / length_m), last = at;
      double force = viscous * rate + friction * bristles + gas_N;
      if (pitch_m > 0) force += cogging_N * std::sin(2 * kPi * at / pitch_m);
      if (i / 300.0 > moved_s) force *= std::exp(-(i / 300.0 - moved_s) / 0.1);
      x.push_back(at + 1e-6 * normal(random)), f.push_back(force + 2 * normal(random));
    }
    return record_of(300, x, f);
  }
};

TEST(Rest, AfterADamperIsStoppedIsNotJudged) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(one_mass(0, 0, true), {Damper().record()}, {});
  EXPECT_NE(said(d).find("presliding_hysteresis on link 1-0"), std::string::npos) << said(d);
  EXPECT_NE(said(d).find("force_offset on link 1-0"), std::string::npos) << said(d);
  EXPECT_LT(d.extended.holdout_nrmse_percent.at(0), 3);  // 2 N of noise in 250 N rms: 0.8 %
}

bool names_cogging(const diagnosis::Diagnosis& d) {
  bool any = false;
  for (const diagnosis::Cause& c : d.causes) any = any || c.effect == "cogging";
  for (const diagnosis::NamedPlace& p : d.ambiguous_with) any = any || p.effect == "cogging";
  return any;
}

// 40 mm of way: five pitches of 8 mm are a force that repeats; half a pitch of 80 mm is a spring to whoever looks.
TEST(Rest, WhatRepeatsHasToBeSeenToRepeat) {
  Damper damper;
  damper.moved_s = damper.recorded_s, damper.friction = 0, damper.gas_N = 0;
  damper.pitch_m = 0.008, damper.cogging_N = 60;
  EXPECT_TRUE(names_cogging(diagnosis::diagnose(one_mass(0, 0, true), {damper.record()}, {})));
  damper.pitch_m = 0.08;
  EXPECT_FALSE(names_cogging(diagnosis::diagnose(one_mass(0, 0, true), {damper.record()}, {})));
}

}  // namespace

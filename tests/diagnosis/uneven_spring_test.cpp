// A spring that is stiffer one way, on a base: a damper that would drive one way looks like it.
#include <cmath>
#include <random>

#include "host_sim/diagnosis/doubts/possible.hpp"
#include "host_sim/diagnosis/fit/evaluator.hpp"
#include "two_masses.hpp"

namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kStiffness_N_m = 1633, kViscous_N_s_m = 0.6, kQuadratic_N_m2 = -3300;
constexpr double kBase_m_s2 = 1.5, kBase_Hz = 6.3;  // beside the resonance of 6.43 Hz
constexpr int kFiner = 8;                           // steps of the plant in a sample

// 1 kg. Its velocity and the base's acceleration, whose own noise integrates to a drift as large as the motion.
host_sim::Record record(double each_s, int samples) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto base = [](double t) { return kBase_m_s2 * std::sin(kTwoPi * kBase_Hz * t); };
  // u: against the base; v: of the mass. The base: x = -a / w^2, and so on
  const double omega = kTwoPi * kBase_Hz;
  const auto rate = [&](double t, double v) { return v + kBase_m_s2 / omega * std::cos(omega * t); };
  const auto acceleration = [&](double t, double u, double v) {
    return -kStiffness_N_m * u - kViscous_N_s_m * rate(t, v) - kQuadratic_N_m2 * u * u;
  };
  host_sim::Record made;
  made.file = "shaken.csv", made.sample_period_s = each_s;
  made.channels = {{"acceleration_base_m_s2", host_sim::Quantity::kAcceleration, rig_file::kBase, {}},
                   {"velocity_1_m_s", host_sim::Quantity::kVelocity, 1, {}}};
  const double h = each_s / kFiner;
  double u = 0.02, v = 0;
  for (int k = 0; k < kFiner * samples; ++k) {
    const double t = k * h;
    if (k % kFiner == 0) {
      made.channels[0].values.push_back(base(t) + 0.05 * normal(random) + 0.02 * std::sin(kTwoPi * 0.15 * t));
      made.channels[1].values.push_back(v + 0.004 * normal(random));
    }
    const double u1 = rate(t, v), v1 = acceleration(t, u, v);
    const double u2 = rate(t + h / 2, v + h / 2 * v1), v2 = acceleration(t + h / 2, u + h / 2 * u1, v + h / 2 * v1);
    const double u3 = rate(t + h / 2, v + h / 2 * v2), v3 = acceleration(t + h / 2, u + h / 2 * u2, v + h / 2 * v2);
    const double u4 = rate(t + h, v + h * v3), v4 = acceleration(t + h, u + h * u3, v + h * v3);
    u += h / 6 * (u1 + 2 * u2 + 2 * u3 + u4), v += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
  }
  return made;
}

rig_file::RigModel rig() {
  rig_file::RigModel made;
  made.dofs.resize(1), made.links.resize(1);
  made.dofs[0].mass_kg.value = 1;
  made.links[0].a = 1, made.links[0].b = rig_file::kBase;
  made.links[0].stiffness_N_m.estimate = made.links[0].viscous_N_s_m.estimate = true;
  return made;
}

// Its second harmonic is that of |w| too: 3.9 N s/m of it beside a damper of 0.6 N s/m, which would drive one way.
TEST(UnevenSpring, IsSeenBesideTheDriftOfItsBase) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig(), {record(1.0 / 64, 4096)}, {});
  EXPECT_TRUE(d.names("quadratic_stiffness", "link 1-base")) << two_masses::said(d);
  for (const diagnosis::NamedPlace& p : d.ambiguous_with) EXPECT_NE(p.effect, "asymmetric_viscous");
  EXPECT_NEAR(two_masses::value_of(d.extended, "quadratic_stiffness[1-base]"), kQuadratic_N_m2, 400);
}

}  // namespace

namespace diagnosis::runs {
namespace {

// A mass that a tone moves, its damper known, beside a law that was added: nothing is fitted, so no interval excuses.
struct Moved {
  System system = make_system(rig());
  std::vector<Prepared> records;
  State state;
  Moved(Kind kind, double value, double damper) {
    host_sim::Record tone;
    tone.file = "tone.csv", tone.sample_period_s = 0.01;
    tone.channels = {{"displacement_base_m", host_sim::Quantity::kDisplacement, rig_file::kBase, {}},
                     {"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}}};
    for (int k = 0; k < 1000; ++k) {
      tone.channels[0].values.push_back(0);
      tone.channels[1].values.push_back(0.02 * std::sin(kTwoPi * 1.3 * 0.01 * k));
    }
    records = prepare_all(rig(), {tone}, {});
    for (const auto& [of, q] : {std::pair{Kind::kViscous, damper}, std::pair{kind, value}}) {
      ModelTerm t;
      t.term = on_link(of, 0), t.value = q;
      state.model.push_back(t);
    }
    state.model[1].added = true;
    ModelTerm mass;
    mass.term = on_dof(Kind::kMass, 0), mass.value = 1;
    state.model.insert(state.model.begin(), mass);
    ModelTerm spring;
    spring.term = on_link(Kind::kStiffness, 0), spring.value = std::pow(kTwoPi * 1.3, 2);
    state.model.insert(state.model.begin() + 1, spring);
    state.seen = {Window{0, 0, 500, {}, false}};
    state.seen[0].state = Evaluator(system, state.model, records).carried_state(state.seen[0]);
  }
  bool drives() const { return drives_a_link(Task{system, records, 1}, state, {Candidate{{state.model[3].term}}}); }
};

// c w + q |w|: c - |q| one way
TEST(PossibleLaw, ADamperTakesEnergyBothWays) {
  EXPECT_FALSE(Moved(Kind::kAsymmetricViscous, 0.015, 0.02).drives());
  EXPECT_FALSE(Moved(Kind::kAsymmetricViscous, -0.015, 0.02).drives());
  EXPECT_TRUE(Moved(Kind::kAsymmetricViscous, 0.025, 0.02).drives());
  EXPECT_TRUE(Moved(Kind::kAsymmetricViscous, -0.025, 0.02).drives());
}

// c + q u^2: at 20 mm 0.02 - 45 * 4e-4 = 0.002, and 0.02 - 60 * 4e-4 = -0.004; a spring gives back what it takes
TEST(PossibleLaw, ADamperTakesEnergyAllAlongTheWay) {
  EXPECT_FALSE(Moved(Kind::kDisplacementDamping, -40, 0.02).drives());
  EXPECT_TRUE(Moved(Kind::kDisplacementDamping, -60, 0.02).drives());
  EXPECT_FALSE(Moved(Kind::kQuadraticStiffness, -60, 0.02).drives());
}

// A damper of the rig below nought drives by itself: what takes some of that back is not held against it.
TEST(PossibleLaw, WhatTheRigItselfPutsInIsNotTheirs) {
  EXPECT_FALSE(Moved(Kind::kCubicDamping, 0.1, -0.02).drives());
  EXPECT_TRUE(Moved(Kind::kCubicDamping, -0.1, -0.02).drives());
}

// 1 kg, of which half may be missing, but not one and a half: at one tone a spring reads as a mass below nought.
TEST(PossibleLaw, AMassErrorLeavesAMass) {
  Moved moved(Kind::kQuadraticStiffness, 0, 0.02);
  ModelTerm& error = moved.state.model[3];
  error.term = on_dof(Kind::kMassError, 0);
  for (const auto& [value, less_than_none] : {std::pair{0.5, false}, std::pair{-0.5, false}, std::pair{-1.5, true}}) {
    error.value = value;
    EXPECT_EQ(lightens_below_nought(moved.state, {Candidate{{error.term}}}), less_than_none) << value;
  }
}

// What its interval allows to be nought is not held against it.
TEST(PossibleLaw, AnIntervalExcuses) {
  Moved moved(Kind::kAsymmetricViscous, 0.025, 0.02);
  moved.state.model[3].known = false;
  // pulls of 1, up and down, on 100 blocks of weight 1e3: a deviation of 1e-4; of weight 10: 0.01
  const auto weigh = [&](double weight) {
    Fitted& f = moved.state.fit;
    f.ok = true, f.block_length = 1000, f.gram.clear(), f.score.clear();
    for (int i = 0; i < 100; ++i)
      f.gram.push_back(Mat::Constant(1, 1, weight)), f.score.push_back(Vec::Constant(1, i % 2 ? 1 : -1));
  };
  weigh(1e3);
  EXPECT_TRUE(moved.drives());
  weigh(10);
  EXPECT_FALSE(moved.drives());
}

}  // namespace
}  // namespace diagnosis::runs

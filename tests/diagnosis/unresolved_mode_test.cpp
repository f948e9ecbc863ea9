// A hidden mass that beats with the rig, and one that has no time to.
#include "host_sim/diagnosis/doubts/unresolved_mode.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kOwn_Hz = 3.1831;  // of 1 kg on 400 N/m: 20 rad/s

rig_file::RigModel rig() {
  rig_file::RigModel made;
  made.dofs.resize(1), made.links.resize(1);
  made.dofs[0].mass_kg.value = 1, made.links[0].a = 1, made.links[0].stiffness_N_m.value = 400;
  made.links[0].viscous_N_s_m.estimate = made.links[0].coulomb_N.estimate = true;
  return made;
}

Model hiding(double mass_kg, double hertz) {
  ModelTerm mass, spring, hidden;
  mass.term = on_dof(Kind::kMass, 0), mass.value = 1;
  spring.term = on_link(Kind::kStiffness, 0), spring.value = 400;
  hidden.term = on_dof(Kind::kResonance, 0, hertz, 0.02), hidden.value = mass_kg;
  return {mass, spring, hidden};
}

// Tuned: mu = 0.001 splits w by +-sqrt(mu) / 2, 0.0316 of 3.183 Hz in all. Far away: next to nothing is moved. 0.25 kg at 6.366 Hz: with
// x = (w / 20)^2 the two modes are x^2 - 6 x + 4 = 0, roots 0.7639 and 5.2361, w = 17.48 and 45.77 rad/s.
TEST(UnresolvedMode, HowFarTwoModesAreApart) {
  const System system = make_system(rig());
  EXPECT_NEAR(split_Hz(system, hiding(0.001, kOwn_Hz)), 0.1007, 0.0005);
  EXPECT_NEAR(split_Hz(system, hiding(1e-6, 5.0)), 5.0 - kOwn_Hz, 0.001);
  EXPECT_NEAR(split_Hz(system, hiding(0.25, 2 * kOwn_Hz)), (45.77 - 17.48) / (2 * M_PI), 0.003);
  EXPECT_EQ(split_Hz(system, {hiding(1, 1)[0], hiding(1, 1)[1]}), 0);
}

TEST(UnresolvedMode, AToneLastsAsLongAsItIs) {
  Vec tone(1000), dying(4000);
  for (Index k = 0; k < tone.size(); ++k) tone[k] = std::sin(0.3 * static_cast<double>(k));
  EXPECT_NEAR(lasts_s(tone, 0.01), 10, 0.05);
  // exp(-t / tau): 1.5 (tau / 4)^2 / (3 tau / 32) = tau
  for (Index k = 0; k < dying.size(); ++k) dying[k] = std::exp(-0.002 * static_cast<double>(k)) * std::sin(0.3 * k);
  EXPECT_NEAR(lasts_s(dying, 0.01), 5, 0.1);
}

// A beat of 9.9 s: after 4 s the amplitude has only fallen, after 6 s it comes back; a rig that is driven shows it at once.
TEST(UnresolvedMode, IsOneThatEndsBeforeTheTwoAreOpposed) {
  const System system = make_system(rig());
  Candidate mode;
  mode.terms = {hiding(0.001, kOwn_Hz)[2].term};
  const auto is = [&](double duration_s, bool driven) {
    host_sim::Record record;
    record.file = "decay.csv", record.sample_period_s = 0.01;
    record.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}}};
    if (driven) record.channels.push_back({"force_1_N", host_sim::Quantity::kForce, 1, {}});
    for (int k = 0; k < static_cast<int>(100 * duration_s); ++k) {
      record.channels[0].values.push_back(std::sin(0.2 * k));
      if (driven) record.channels[1].values.push_back(std::cos(0.3 * k));
    }
    const std::vector<Prepared> records = prepare_all(rig(), {record}, {});
    State with;
    with.model = hiding(0.001, kOwn_Hz);
    return is_unresolved_mode(Task{system, records, 1}, with, {mode});
  };
  EXPECT_TRUE(is(4, false));
  EXPECT_FALSE(is(6, false));
  EXPECT_FALSE(is(4, true));
}

// A damper that grows warm makes two rates of decay of one: so does a hidden mass of half a gram that is tuned to the rig, and it was
// `explained`, with all numbers VALID.
TEST(UnresolvedMode, IsNotNamedForADamperThatDrifts) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  host_sim::Record record;
  record.file = "decay.csv", record.sample_period_s = 0.005;
  record.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}}};
  constexpr int kFiner = 20;
  const double h = 0.005 / kFiner;
  double x = 0.15, v = 0;
  for (int k = 0; k < 1200; ++k) {
    record.channels[0].values.push_back(x + 1e-4 * normal(random));
    for (int i = 0; i < kFiner; ++i) {
      v += h * (-400 * x - (0.6 + 0.1 * (k * 0.005)) * v);
      v = std::copysign(std::max(0.0, std::abs(v) - h * 0.6), v);
      x += h * v;
    }
  }
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig(), {record}, {});
  for (const diagnosis::Cause& c : d.causes) EXPECT_NE(c.effect, "unmodelled_resonance") << two_masses::said(d);
  for (const diagnosis::NamedPlace& p : d.ambiguous_with) EXPECT_NE(p.effect, "unmodelled_resonance");
}

}  // namespace
}  // namespace diagnosis::runs

// Of which diagnoses the balance of energies is asked, and what it takes back.
#include "host_sim/programs/diagnose/energies_say.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using diagnosis::Diagnosis;
using diagnosis::Verdict;
using host_sim::Quantity;

constexpr size_t kLate = 3;  // samples, ms

// 60 tones from 2 to 20 Hz of unlike phases.
double force_N(double t, double level, int phases) {
  double sum = 0.0;
  for (int k = 0; k < 60; ++k) sum += std::sin(2.0 * M_PI * (2.0 + 0.3 * k) * t + 1.3 * phases * k * k);
  return level * 7.0 * sum / std::sqrt(30.0);
}

// 1.7 kg on 5200 N/m with 6.5 N s/m, and 12 N s/m more within a millimetre of the centre, which no rig file states. The force is read late.
host_sim::Record record(double level, int phases) {
  std::mt19937 random(static_cast<unsigned>(phases));
  std::normal_distribution<double> normal;
  host_sim::Channel force{"force_1_N", Quantity::kForce, 1, {}, 0.0},
      place{"displacement_1_m", Quantity::kDisplacement, 1, {}, 0.0};
  constexpr double kStep = 1e-5;
  double x = 0.0, v = 0.0;
  for (long k = 0; k < 1000000; ++k) {
    const double t = kStep * static_cast<double>(k), f = force_N(t, level, phases);
    if (k % 100 == 0) {
      place.values.push_back(x + 1e-5 * normal(random));
      force.values.push_back(force_N(t - 1e-3 * static_cast<double>(kLate), level, phases));
    }
    v += kStep * (f - 5200.0 * x - (6.5 + 12.0 * std::exp(-x * x / 1e-6)) * v) / 1.7;
    x += kStep * v;
  }
  host_sim::Record made;
  made.file = "shaken.csv", made.sample_period_s = 1e-3, made.channels = {force, place};
  return made;
}

// As the runs have it: content with a channel's fault, and eight times the noise is left.
Diagnosis content_with(const char* effect) {
  Diagnosis d;
  d.verdict = Verdict::kExplained, d.extended_misfit = 8.0;
  d.extended_rig.name = "slide", d.extended_rig.dofs.resize(1), d.extended_rig.links.resize(1);
  d.extended_rig.dofs[0].mass_kg.value = 1.7;
  rig_file::Link& link = d.extended_rig.links[0];
  link.a = 1, link.stiffness_N_m.value = 5200.0, link.viscous_N_s_m.estimate = link.coulomb_N.estimate = true;
  d.extended_rig.channels.resize(1);
  d.extended_rig.channels[0].name = "force_1_N", d.extended_rig.channels[0].delay_us = 1e3 * static_cast<double>(kLate);
  d.extended.parameters = {{"viscous[1-0]", 7.0, "N s/m", 0.1}, {"coulomb[1-0]", 0.9, "N", 0.01}};
  diagnosis::Cause cause;
  cause.effect = effect, cause.where = "channel force_1_N";
  cause.parameters = {{std::string(effect) + "[1]", 3e-3, "s", 1e-5}};
  d.causes = {cause};
  return d;
}

Verdict asked(const char* effect) {
  Diagnosis d = content_with(effect);
  host_sim::ask_energies({record(0.6, 1), record(1.2, 2)}, d);
  EXPECT_EQ(d.extended.parameters[0].may_be_bent, d.verdict == Verdict::kPartly);
  return d.verdict;
}

// The extended rig file has the delay: estimate takes it out, and tests the numbers beside it.
TEST(EnergiesSay, AreAskedBesideADelayThatTheRigFileStates) { EXPECT_EQ(asked("sensor_delay"), Verdict::kPartly); }

// A gain is in no rig file: estimate would be asked of other forces than the runs were.
TEST(EnergiesSay, AreNotAskedBesideAGain) { EXPECT_EQ(asked("sensor_gain"), Verdict::kExplained); }

}  // namespace

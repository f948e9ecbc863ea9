// Records whose times are wrong by a factor: all masses, or all springs, seem to be.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <random>

#include "host_sim/diagnosis/diagnosis.hpp"
#include "host_sim/diagnosis/numbers/parameter_status.hpp"

namespace {

using namespace diagnosis;
using host_sim::Quantity;
using host_sim::Record;

constexpr double kTwoPi = 6.28318530717958647692;

// 2 and 1.5 kg on 4000 N/m, 8 N s/m to the ground and 3000 N/m, 6 N s/m between. Forty tones from 0.5 to 15 Hz on the first; the steady
// motion of each tone: X2 = k X1 / (k - m2 w^2), k = 3000 + 6 j w, and (ground + k - m1 w^2) X1 - k X2 = F. 20 s at 500 Hz, said to be rate_Hz.
Record said_at(double rate_Hz, Quantity quantity) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> turn(0, kTwoPi);
  std::normal_distribution<double> noise;
  std::vector<double> f(10000), first(f), second(f);
  for (int i = 0; i < 40; ++i) {
    const std::complex<double> jw(0, kTwoPi * (0.5 + 0.37 * i)), start = std::polar(1.0, turn(random));
    const std::complex<double> k = 3000.0 + 6.0 * jw, ratio = k / (k + 1.5 * jw * jw),
                               x1 = 1.0 / (4000.0 + 8.0 * jw + k + 2.0 * jw * jw - k * ratio),
                               read = quantity == Quantity::kAcceleration ? jw * jw : 1.0;
    for (size_t n = 0; n < f.size(); ++n) {
      const std::complex<double> at = start * std::exp(jw * (static_cast<double>(n) / 500));
      f[n] += at.real(), first[n] += (read * x1 * at).real(), second[n] += (read * x1 * ratio * at).real();
    }
  }
  const double size = quantity == Quantity::kAcceleration ? 0.02 : 1e-5;
  for (size_t n = 0; n < f.size(); ++n) first[n] += size * noise(random), second[n] += size * noise(random);
  Record record;
  record.file = "clock.csv", record.sample_period_s = 1 / rate_Hz;
  const std::string unit = quantity == Quantity::kAcceleration ? "acceleration_%_m_s2" : "displacement_%_m";
  const auto named = [&](char dof) { return std::string(unit).replace(unit.find('%'), 1, 1, dof); };
  record.channels = {
      {"force_1_N", Quantity::kForce, 1, f}, {named('1'), quantity, 1, first}, {named('2'), quantity, 2, second}};
  return record;
}

rig_file::RigModel two_masses() {
  rig_file::RigModel rig;
  rig.dofs.resize(2), rig.links.resize(2);
  rig.dofs[0].mass_kg.value = 2, rig.dofs[1].mass_kg.value = 1.5;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround, rig.links[0].stiffness_N_m.value = 4000;
  rig.links[1].a = 1, rig.links[1].b = 2, rig.links[1].stiffness_N_m.value = 3000;
  for (rig_file::Link& link : rig.links) link.viscous_N_s_m.estimate = true;
  return rig;
}

bool speaks_of_the_clock(const Diagnosis& d) {
  for (const std::string& advice : d.advice)
    if (advice.find("look at the clock first") != std::string::npos) return true;
  return false;
}

// Twice the rate: of displacements masses of a quarter and dampers of a half explain all; 4.0 +- 0.01 went out VALID for 8.
TEST(Clock, OfTwiceTheRateIsToldWhereAllMassesSeemWrong) {
  const Diagnosis d = diagnose(two_masses(), {said_at(1000, Quantity::kDisplacement)}, {});
  EXPECT_TRUE(speaks_of_the_clock(d)) << verdict_word(d.verdict);
  for (const Parameter& p : d.extended.parameters) {
    if (p.name.find("viscous") == std::string::npos) continue;
    EXPECT_STRNE(status_word(p, d.extended_fits()), "VALID") << p.name << ' ' << p.value;
  }
}

TEST(Clock, IsNotSpokenOfWhereItIsRight) {
  EXPECT_FALSE(speaks_of_the_clock(diagnose(two_masses(), {said_at(500, Quantity::kDisplacement)}, {})));
  rig_file::RigModel one_wrong = two_masses();
  one_wrong.links[1].stiffness_N_m.value = 6000;
  EXPECT_FALSE(speaks_of_the_clock(diagnose(one_wrong, {said_at(500, Quantity::kDisplacement)}, {})));
  rig_file::RigModel in_grams = two_masses();
  for (rig_file::Dof& dof : in_grams.dofs) dof.mass_kg.value *= 1000;
  EXPECT_FALSE(speaks_of_the_clock(diagnose(in_grams, {said_at(500, Quantity::kDisplacement)}, {})));
}

}  // namespace

// A drive whose band does nothing. The width is fitted, not taken from a list of trials: with a width that is off, the share is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;
using host_sim::Quantity;

constexpr double kMass_kg = 2, kStiffness_N_m = 8000, kViscous_N_s_m = 12, kRate_Hz = 1000;
constexpr int kFiner = 5;

// Forty sines of 2 to 20 Hz, 40 N rms, of which `width_N` to either side does not act.
host_sim::Record record_of(double width_N, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> phase(0, 2 * M_PI), hertz(2, 20);
  std::normal_distribution<double> normal;
  std::vector<std::pair<double, double>> sines;
  for (int i = 0; i < 40; ++i) sines.emplace_back(2 * M_PI * hertz(random), phase(random));
  const auto asked = [&](double t) {
    double sum = 0;
    for (const auto& [omega, at] : sines) sum += 40 / std::sqrt(20.0) * std::sin(omega * t + at);
    return sum;
  };
  const auto slope = [&](const State& s, double force) {
    State out;
    out.x[0] = s.v[0];
    out.v[0] =
        (force - std::clamp(force, -width_N, width_N) - kStiffness_N_m * s.x[0] - kViscous_N_s_m * s.v[0]) / kMass_kg;
    return out;
  };
  std::vector<double> force, x, a;
  State s;
  const double h = 1 / (kRate_Hz * kFiner);
  for (int n = 0; n < 20000; ++n) {
    const double t = n / kRate_Hz;
    force.push_back(asked(t) + 0.1 * normal(random));
    x.push_back(s.x[0] + 2e-5 * normal(random));
    a.push_back(slope(s, asked(t)).v[0] + 0.1 * normal(random));
    for (int i = 0; i < kFiner; ++i) {
      const double at = t + i * h;
      s = stepped(s, h, asked(at), asked(at + h / 2), asked(at + h), slope);
    }
  }
  host_sim::Record record;
  record.file = "band.csv", record.sample_period_s = 1 / kRate_Hz;
  record.channels = {{"force_1_N", Quantity::kForce, 1, force},
                     {"displacement_1_m", Quantity::kDisplacement, 1, x},
                     {"acceleration_1_m_s2", Quantity::kAcceleration, 1, a}};
  return record;
}

rig_file::RigModel damped_mass_on_a_spring() {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg.value = kMass_kg;
  rig.links[0].a = 1;
  rig.links[0].stiffness_N_m.value = kStiffness_N_m;
  rig.links[0].viscous_N_s_m.estimate = true;
  return rig;
}

// Trials stand a third apart. A share of one that is fitted beside a width a seventh too large came out at 0.77, +- 0.001. A band
// that the force crosses within two samples (4 N here: 3 N a sample, rms) is a twentieth off in both, and their product right.
TEST(DeadBand, ItsWidthIsFitted) {
  const rig_file::RigModel rig = damped_mass_on_a_spring();
  for (const double width_N : {4.0, 8.0, 12.0}) {
    const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {record_of(width_N, static_cast<unsigned>(width_N))}, {});
    ASSERT_EQ(said(d), "explained, drive_dead_band on channel force_1_N") << width_N;
    const diagnosis::Parameter share = parameter_of(d.extended, "drive_dead_band[1]");
    const double width = value_of(d.extended, "drive_dead_band_width[1]");
    if (width_N > 4) {
      EXPECT_NEAR(share.value, 1.0, 3 * share.std) << width_N;
    }
    EXPECT_NEAR(share.value * width, width_N, 0.02 * width_N);
    EXPECT_LT(share.std, 0.05) << width_N;
    EXPECT_NEAR(width, width_N, 0.1 * width_N);
    EXPECT_NEAR(value_of(d.extended, "viscous[1-0]"), kViscous_N_s_m, 0.02 * kViscous_N_s_m);
  }
}

// The extended rig file has it: with that one nothing is missing. A rig file that states what the drive loses is believed.
TEST(DeadBand, OfTheExtendedRigIsNotMissing) {
  const std::vector<host_sim::Record> records = {record_of(8, 8)};
  const diagnosis::Diagnosis first = diagnosis::diagnose(damped_mass_on_a_spring(), records, {});
  ASSERT_EQ(first.extended_rig.dofs[0].effects.size(), 1u);
  const rig_file::Effect& written = first.extended_rig.dofs[0].effects[0];
  EXPECT_EQ(written.kind, "drive_dead_band");
  EXPECT_NEAR(written.coefficient.value * written.shape.at("dead_band_N"), 8, 0.16);
  EXPECT_EQ(said(diagnosis::diagnose(first.extended_rig, records, {})), "none");
}

}  // namespace

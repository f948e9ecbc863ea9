// Friction whose bristles are damped (LuGre) in free runs: its law and slopes by hand, and a mass whose rig file says dry friction.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/simulate/simulator.hpp"
#include "two_masses.hpp"

namespace {

using namespace diagnosis;
using namespace diagnosis::runs;
using two_masses::parameter_of;
using two_masses::said;

// dz/dt = (w - |w| z) / length = (0.2 - 0.1) / 0.1 = 1 1/s; z + tau dz/dt = 0.5 + 0.05. Its slopes: tau (1 - z) / length = 0.25 in
// w, 1 - tau |w| / length = 0.9 in z, and a part of 0.05 that goes with tau and against the length.
TEST(BristleDamping, LawAndItsSlopes) {
  double by_z = 0;
  const LawValue f = bristles(0.2, 0.5, 0.1, 0.05, by_z);
  EXPECT_NEAR(f.force, 0.55, 1e-12);
  EXPECT_NEAR(f.by_w, 0.25, 1e-12);
  EXPECT_NEAR(by_z, 0.9, 1e-12);
  EXPECT_NEAR(f.by_log_shape, -0.05, 1e-12);
  EXPECT_NEAR(f.by_shape2, 0.05, 1e-12);
}

// 1 kg on 40 N/m against 1 N of friction that bends over 50 mm and is damped for 0.1 s, let go at 1 m; 100 Hz.
struct Bristled {
  System system;
  Model model;
  std::vector<Prepared> records;
  Bristled(double level, double log_length, double log_time) {
    rig_file::RigModel rig;
    rig.dofs.resize(1), rig.links.resize(1);
    rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
    system = make_system(rig);
    add(on_dof(Kind::kMass, 0), 1, true), add(on_link(Kind::kStiffness, 0), 40, true);
    Term friction = on_link(Kind::kPresliding, 0, 0.05 * std::exp(log_length));
    friction.shape2 = 0.1 * std::exp(log_time);
    add(friction, level, false);
    model.back().shape_free = model.back().shape2_free = true;
    Prepared p;
    p.step_s = 0.01, p.samples = 151, p.period_s = 1, p.top_Hz = 2;
    p.force = {Vec()}, p.guess.resize(2);
    p.guess[0] = {true, Vec::Zero(151), Vec::Zero(151), Vec::Zero(151)};
    records.push_back(p);
  }
  void add(const Term& term, double value, bool known) {
    ModelTerm t;
    t.term = term, t.value = value, t.known = known;
    model.push_back(t);
  }
  Vec run(Sensitivity* total) {
    Simulator s(system, model, records[0]);
    Vec y(3);
    y << 1, 0, 0.2;
    if (total) *total = Sensitivity::Zero(3, 6), total->leftCols(3).setIdentity();
    s.start(0, y);
    for (Index k = 0; k < 140; ++k) s.advance(k, y, total);
    return y;
  }
};

TEST(BristleDamping, SensitivitiesAreThoseOfDifferences) {
  Sensitivity total;
  Bristled(1, 0, 0).run(&total);
  const double step = 1e-4;
  for (int column = 0; column < 3; ++column) {
    const auto run = [&](double d) {
      return Bristled(1 + (column == 0 ? d : 0), column == 1 ? d : 0, column == 2 ? d : 0).run(nullptr);
    };
    const Vec slope = (run(step) - run(-step)) / (2 * step);
    for (Index row = 0; row < 3; ++row)
      EXPECT_NEAR(total(row, 3 + column), slope[row], 5e-3 * (0.1 + std::abs(slope[row]))) << row << ", " << column;
  }
}

// 2 kg, 20 kN/m (16 Hz) and 20 N s/m under six tones; friction of 2 N that bends over 0.1 mm and is damped for `damped_s`; 1 kHz, the
// displacement alone with 1 % noise. Heun's rule with 32 steps a sample.
host_sim::Record record_of(double damped_s) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  host_sim::Record r;
  r.file = "mass.csv", r.sample_period_s = 1e-3;
  std::vector<double> x, f;
  double s[3] = {0, 0, 0};
  const auto force = [](double t) {
    double sum = 0;
    for (int i = 0; i < 6; ++i) sum += 6 * std::cos(6.283185307179586 * (7.3 + 4.17 * i) * t + 1.9 * i * i);
    return sum;
  };
  const auto slope = [&](const double* y, double t, double* d) {
    const double bends = (y[1] - std::abs(y[1]) * y[2]) / 1e-4;
    d[0] = y[1], d[1] = (force(t) - 2e4 * y[0] - 20 * y[1] - 2 * (y[2] + damped_s * bends)) / 2, d[2] = bends;
  };
  const double h = 1e-3 / 32;
  for (int i = 0; i < 20000; ++i) {
    const double t = i * 1e-3;
    x.push_back(s[0]), f.push_back(force(t));
    for (int k = 0; k < 32; ++k) {
      double a[3], b[3], next[3];
      slope(s, t + k * h, a);
      for (int j = 0; j < 3; ++j) next[j] = s[j] + h * a[j];
      slope(next, t + (k + 1) * h, b);
      for (int j = 0; j < 3; ++j) s[j] += 0.5 * h * (a[j] + b[j]);
    }
  }
  double square = 0;
  for (double value : x) square += value * value / static_cast<double>(x.size());
  for (double& value : x) value += 0.01 * std::sqrt(square) * normal(random);
  r.channels = {{"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x},
                {"force_1_N", host_sim::Quantity::kForce, 1, f}};
  return r;
}

TEST(BristleDamping, IsFoundWithNumbersThatHoldTheTruth) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg = {2, false};
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m = {2e4, false};
  rig.links[0].viscous_N_s_m.estimate = rig.links[0].coulomb_N.estimate = true;
  const Diagnosis d = diagnose(rig, {record_of(0.004)}, {});
  ASSERT_EQ(said(d), "explained, presliding_hysteresis on link 1-0");
  const diagnosis::Parameter viscous = parameter_of(d.extended, "viscous[1-0]"),
                             level = parameter_of(d.extended, "presliding_hysteresis[1-0]");
  EXPECT_NEAR(viscous.value, 20, 3 * viscous.std);
  EXPECT_LT(viscous.std, 1);
  EXPECT_NEAR(level.value, 2, 3 * level.std);
  EXPECT_NEAR(parameter_of(d.extended, "bristle_time[1-0]").value, 0.004, 0.001);
  // bristles without damping are given next to none
  for (const diagnosis::Parameter& p : diagnose(rig, {record_of(0)}, {}).extended.parameters)
    EXPECT_FALSE(p.name == "bristle_time[1-0]" && p.value > 0.0004) << p.value;
}

}  // namespace

// A force that stays at its sample until the next one, seen by an accelerometer where it acts.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/diagnosis/simulate/simulator.hpp"
#include "two_masses.hpp"

namespace {

using two_masses::parameter_of;
using two_masses::said;

// 1 kg, free, 100 Hz, forces of 3, -1 and 2 N: held, it moves at 0.03 and 0.02 m/s after one and two samples, has gone
// 0.00015 and 0.00015 + 0.0003 - 0.00005 = 0.0004 m, and its acceleration at a sample is the force of that sample, at the last one too.
TEST(HeldForce, ActsUntilTheNextSample) {
  using namespace diagnosis;
  using namespace diagnosis::runs;
  rig_file::RigModel rig;
  rig.dofs.resize(1);
  const System system = make_system(rig);
  Model model(1);
  model[0].term = on_dof(Kind::kMass, 0), model[0].value = 1;
  Prepared p;
  p.step_s = p.read_every_s = 0.01, p.samples = 8, p.period_s = 1, p.top_Hz = 2, p.held = true;
  Vec force = Vec::Zero(8);
  force << 3, -1, 2, 0, 0, 0, 0, 5;
  p.force = {force}, p.guess.resize(2);
  Simulator s(system, model, p);
  Vec y = Vec::Zero(2), a;
  s.start(0, y);
  s.accelerations(0, y, a, nullptr);
  EXPECT_NEAR(a[0], 3, 1e-12);
  s.advance(0, y, nullptr);
  EXPECT_NEAR(y[0], 0.00015, 1e-12);
  EXPECT_NEAR(y[1], 0.03, 1e-12);
  s.accelerations(1, y, a, nullptr);
  EXPECT_NEAR(a[0], -1, 1e-12);
  s.advance(1, y, nullptr);
  EXPECT_NEAR(y[0], 0.0004, 1e-12);
  EXPECT_NEAR(y[1], 0.02, 1e-12);
  s.accelerations(7, y, a, nullptr);
  EXPECT_NEAR(a[0], 5, 1e-12);
}

enum class Between { kHeld, kSmooth };
// What drives the rig and what is read of it: accelerations, and where they are asked for displacements.
struct Driven {
  int tones = 6;
  bool displacement = false;
};

// 2 kg, 20 kN/m (16 Hz) and 30 N s/m under tones, 1 kHz, the acceleration `late_s` late, with a noise of 0.2 %, the displacement as
// it is. Fourth-order Runge-Kutta, eight steps a sample.
host_sim::Record record_of(Between between, double late_s, const Driven& driven = {}) {
  std::mt19937_64 random(31);
  std::normal_distribution<double> normal;
  host_sim::Record r;
  r.file = "mass.csv", r.sample_period_s = 1e-3;
  std::vector<double> a, f, x;
  const auto smooth = [&](double t) {
    double sum = 0;
    for (int i = 0; i < driven.tones; ++i) sum += 6 * std::cos(6.283185307179586 * (7.3 + 4.17 * i) * t + 1.9 * i * i);
    return sum;
  };
  two_masses::State s;
  const auto slope = [](const two_masses::State& y, double force) {
    two_masses::State d;
    d.x[0] = y.v[0], d.v[0] = (force - 2e4 * y.x[0] - 30 * y.v[0]) / 2;
    return d;
  };
  const double h = 1e-3 / 8;
  for (int i = -1000; i < 15000; ++i) {
    const double t = i * 1e-3;
    for (int k = 0; k < 8; ++k) {
      const double at = t + k * h;
      if (i >= 0 && k == 0) f.push_back(smooth(t));
      const double now = between == Between::kHeld ? smooth(t) : smooth(at);
      if (i >= 0 && k == 0) a.push_back(slope(s, now).v[0]), x.push_back(s.x[0]);
      const bool held = between == Between::kHeld;
      s = two_masses::stepped(s, h, now, held ? now : smooth(at + h / 2), held ? now : smooth(at + h), slope);
    }
  }
  const int late = static_cast<int>(std::lround(late_s / 1e-3));
  std::vector<double> read = a;
  for (size_t i = 0; i < a.size(); ++i) read[i] = a[i < static_cast<size_t>(late) ? 0 : i - static_cast<size_t>(late)];
  double square = 0;
  for (double value : read) square += value * value / static_cast<double>(read.size());
  for (double& value : read) value += 0.002 * std::sqrt(square) * normal(random);
  r.channels = {{"acceleration_1_m_s2", host_sim::Quantity::kAcceleration, 1, read},
                {"force_1_N", host_sim::Quantity::kForce, 1, f}};
  if (driven.displacement) r.channels.push_back({"displacement_1_m", host_sim::Quantity::kDisplacement, 1, x});
  return r;
}

rig_file::RigModel rig() {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.dofs[0].mass_kg = {2, false};
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[0].stiffness_N_m = {2e4, false};
  rig.links[0].viscous_N_s_m.estimate = true;
  return rig;
}

TEST(HeldForce, IsNamedByAnAccelerometerAloneAndItsRunIsRight) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig(), {record_of(Between::kHeld, 0)}, {});
  EXPECT_EQ(said(d), "explained, force_hold on channel force_1_N");
  EXPECT_EQ(d.force_between_samples, "steps");
  const diagnosis::Parameter viscous = parameter_of(d.extended, "viscous[1-0]");
  EXPECT_NEAR(viscous.value, 30, 3 * viscous.std);
  EXPECT_LT(d.extended.holdout_mse_percent[0], 0.01);  // noise alone: (0.2 %)^2 is 0.0004 %
}

TEST(HeldForce, NeitherASmoothForceNorALateAccelerometerIsOne) {
  EXPECT_EQ(said(diagnosis::diagnose(rig(), {record_of(Between::kSmooth, 0)}, {})), "none");
  const diagnosis::Diagnosis late = diagnosis::diagnose(rig(), {record_of(Between::kSmooth, 0.001)}, {});
  EXPECT_EQ(said(late).find("force_hold"), std::string::npos) << said(late);
  EXPECT_EQ(late.force_between_samples, "smooth");
}

// First-order noise: 0.8 of it stays from sample to sample, of variance 1 with new parts of 0.6: 0.6^2 / (1 - 0.8^2).
void add_coloured_noise(std::vector<double>& values, double share, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  double square = 0, noise = 0;
  for (double value : values) square += value * value / static_cast<double>(values.size());
  for (double& value : values) noise = 0.8 * noise + 0.6 * normal(random), value += share * std::sqrt(square) * noise;
}

// 3 % less spring than the rig file says makes the motion late or early, as a hold makes it late.
TEST(HeldForce, AWrongSpringIsNoHold) {
  rig_file::RigModel stiffer = rig();
  stiffer.links[0].stiffness_N_m = {2e4 / 0.97, false};
  host_sim::Record record = record_of(Between::kSmooth, 0, {12, true});
  std::mt19937_64 random(77);
  for (host_sim::Channel& channel : record.channels) add_coloured_noise(channel.values, 0.01, random);
  const diagnosis::Diagnosis d = diagnosis::diagnose(stiffer, {record}, {});
  EXPECT_EQ(said(d), "explained, stiffness_error on link 1-0");
  const diagnosis::Parameter error = parameter_of(d.extended, "stiffness_error[1-0]");
  EXPECT_NEAR(error.value, 2e4 - 2e4 / 0.97, 3 * error.std);
}

}  // namespace

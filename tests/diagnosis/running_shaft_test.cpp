// Shafts that run on or run down: the size of their angle says nothing of the forces on them.
// The plants are closed forms or a fourth-order Runge-Kutta of the test's own.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "host_sim/diagnosis/numbers/parameter_status.hpp"
#include "host_sim/diagnosis/record/series.hpp"
#include "two_masses.hpp"

namespace {

using namespace two_masses;
using host_sim::Quantity;

struct Shaft {
  std::vector<double> angle, speed;
};

// torque(t, speed) over an inertia of one; ten steps of Runge and Kutta a sample.
Shaft run(double speed, double rate_Hz, double duration_s, const std::function<double(double, double)>& torque) {
  Shaft shaft;
  const double h = 0.1 / rate_Hz;
  double u = 0, w = speed;
  for (int n = 0; n < static_cast<int>(duration_s * rate_Hz * 10); ++n) {
    if (n % 10 == 0) shaft.angle.push_back(u), shaft.speed.push_back(w);
    const double t = n * h, a = torque(t, w), b = torque(t + h / 2, w + h / 2 * a),
                 c = torque(t + h / 2, w + h / 2 * b), d = torque(t + h, w + h * c);
    u += h * (w + h / 6 * (a + b + c)), w += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return shaft;
}

rig_file::RigModel rig(double inertia, std::vector<rig_file::Effect> effects = {}) {
  rig_file::RigModel model;
  model.dofs.resize(1), model.links.resize(1);
  model.dofs[0].rotating = true, model.dofs[0].mass_kg.value = inertia, model.dofs[0].mass_kg.estimate = inertia == 0;
  model.links[0].a = 1;
  model.links[0].viscous_N_s_m.estimate = model.links[0].coulomb_N.estimate = true;
  model.links[0].effects = std::move(effects);
  return model;
}

host_sim::Record record_of(double rate_Hz, std::vector<host_sim::Channel> channels) {
  host_sim::Record record;
  record.file = "shaft.csv", record.sample_period_s = 1 / rate_Hz, record.channels = std::move(channels);
  return record;
}

diagnosis::Diagnosis diagnosed(const rig_file::RigModel& model, const std::vector<host_sim::Record>& records) {
  return diagnosis::diagnose(model, records, {});
}

// A wheel of 21 kg m2 that coasts from 41 rad/s. Its sensor wobbles once a turn by 0.3 rad/s, and reads 0.1 rad/s of noise.
host_sim::Record coast(double brake_N_m) {
  const Shaft shaft =
      run(41, 200, 8.4, [&](double t, double w) { return -(1.0 * w + 40 + (t > 5 ? brake_N_m : 0.0)) / 21; });
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal(0, 0.1);
  std::vector<double> reading;
  for (size_t i = 0; i < shaft.speed.size(); ++i)
    reading.push_back(shaft.speed[i] + 0.3 * std::sin(shaft.angle[i]) + normal(random));
  return record_of(200, {{"angular_velocity_1_rad_s", Quantity::kVelocity, 1, reading}});
}

// A brake of twice the friction from 5 s on is no law of the rig. The windows that the fit has seen, and those that it has not, do not
// go together: whatever is said, it is not that nothing is missing. The wobble had passed for the motion's period before.
TEST(RunningShaft, ACoastThatABrakeEndsIsNotExplained) {
  const diagnosis::Diagnosis d = diagnosed(rig(21), {coast(80)});
  EXPECT_NE(d.verdict, diagnosis::Verdict::kNone) << said(d);
  for (const diagnosis::Parameter& p : d.baseline.parameters)
    EXPECT_STRNE(diagnosis::status_word(p, d.verdict == diagnosis::Verdict::kNone), "VALID") << p.name;
}

// Of a line's way 297 only what is off it moves, by 0.7 or 15 rms.
TEST(RunningShaft, WhatTravelsIsToldFromWhatSwings) {
  diagnosis::Series line(100), swing(100), late(100);
  for (int i = 0; i < 100; ++i) {
    line[i] = 3.0 * i + std::sin(0.3 * i);
    swing[i] = 5 + std::sin(0.3 * i);
    late[i] = 1.0 * i + 0.02 * i * i;  // of the slope 3: 297, off its line 15: 0.02 * 99^2 / 13.4
  }
  EXPECT_TRUE(diagnosis::travels(line));
  EXPECT_FALSE(diagnosis::travels(swing));
  EXPECT_TRUE(diagnosis::travels(late));
  // 5 points of i^2 - about their line: (2, -1, -2, -1, 2), squares 4 + 1 + 4 + 1 + 4
  diagnosis::Series square(5);
  square << 0, 1, 4, 9, 16;
  EXPECT_NEAR(diagnosis::square_off_line(square), 14, 1e-12);
}

// A motor of 1.5e-4 kg m2 whose torque steps between two levels, with a constant torque that the rig file does not have.
host_sim::Record driven(double low_N_m, double high_N_m, double offset_N_m, unsigned seed) {
  constexpr double kInertia = 1.5e-4, kViscous = 1.4e-4, kFriction = 0.02;
  const auto command = [&](double t) { return std::fmod(t, 4) < 2 ? low_N_m : high_N_m; };
  const double sign = low_N_m < 0 ? -1 : 1;
  const Shaft shaft = run(sign * 100, 500, 20, [&](double t, double w) {
    return (command(t) - offset_N_m - kViscous * w - kFriction * std::tanh(w / 0.01)) / kInertia;
  });
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> torque, angle, speed;
  for (size_t i = 0; i < shaft.angle.size(); ++i) {
    torque.push_back(command(static_cast<double>(i) / 500) + 2e-4 * normal(random));
    angle.push_back(shaft.angle[i] + 1e-3 * normal(random));
    speed.push_back(shaft.speed[i] + 0.5 * normal(random));
  }
  return record_of(500, {{"torque_1_N_m", Quantity::kForce, 1, torque},
                         {"angle_1_rad", Quantity::kDisplacement, 1, angle},
                         {"angular_velocity_1_rad_s", Quantity::kVelocity, 1, speed}});
}

// The angle runs to 2000 rad and more; what a constant torque of 0.008 N m does to it was a thousandth of that, and 'none'.
TEST(RunningShaft, AConstantTorqueIsNotLostInALargeAngle) {
  const diagnosis::Diagnosis d = diagnosed(rig(0), {driven(0.035, 0.045, 0.008, 1), driven(-0.045, -0.035, 0.008, 2)});
  EXPECT_NE(d.verdict, diagnosis::Verdict::kNone) << said(d);
}

// One direction: dry friction and a constant torque are one column. Their sum is 0.028, and neither is a number.
TEST(RunningShaft, WhatOnlyASumIsKnownOfIsNoNumber) {
  rig_file::Effect offset;
  offset.kind = "force_offset", offset.coefficient.estimate = true;
  const diagnosis::Diagnosis d = diagnosed(rig(0, {offset}), {driven(0.035, 0.045, 0.008, 1)});
  for (const char* name : {"coulomb[1-0]", "force_offset[1-0]"})
    EXPECT_TRUE(parameter_of(d.baseline, name).undetermined) << name;
  EXPECT_FALSE(parameter_of(d.baseline, "viscous[1-0]").undetermined);
  EXPECT_NEAR(value_of(d.baseline, "viscous[1-0]"), 1.4e-4, 0.05 * 1.4e-4);
}

}  // namespace

// Two inertias on a shaft whose end is turned: the speed that is imposed swings about 30 rad/s.
// The plant here is its own: fourth-order Runge-Kutta.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;

constexpr double kTwoPi = 6.283185307179586;
constexpr double kRate_Hz = 1000, kDuration_s = 20, kSpeed_rad_s = 30;
constexpr int kFiner = 10, kSines = 40;
constexpr double kInertia[] = {0.05, 0.03}, kStiffness[] = {180, 120}, kViscous[] = {0.12, 0.09};

struct Turned {
  double angle = 0, speed = kSpeed_rad_s;
};

// The end of the shaft: 40 sines of 1 to 25 Hz, each of 0.12 rad/s, about a speed.
class End {
 public:
  explicit End(std::mt19937_64& random) {
    std::uniform_real_distribution<double> phase(0, kTwoPi), hertz(1, 25);
    for (int i = 0; i < kSines; ++i) omega_.push_back(kTwoPi * hertz(random)), phase_.push_back(phase(random));
  }
  Turned at(double t) const {
    Turned turned;
    turned.angle = kSpeed_rad_s * t;
    for (size_t i = 0; i < omega_.size(); ++i) {
      turned.speed += 0.12 * std::sin(omega_[i] * t + phase_[i]);
      turned.angle -= 0.12 / omega_[i] * (std::cos(omega_[i] * t + phase_[i]) - std::cos(phase_[i]));
    }
    return turned;
  }

 private:
  std::vector<double> omega_, phase_;
};

State slope_of(const State& s, const Turned& end) {
  const double first = kStiffness[0] * (s.x[0] - end.angle) + kViscous[0] * (s.v[0] - end.speed);
  const double second = kStiffness[1] * (s.x[1] - s.x[0]) + kViscous[1] * (s.v[1] - s.v[0]);
  State out;
  out.x[0] = s.v[0], out.x[1] = s.v[1];
  out.v[0] = (second - first) / kInertia[0], out.v[1] = -second / kInertia[1];
  return out;
}

struct Sensors {
  bool end_by_angle, inertias_by_angle;
};

// A thousandth (angles) or a hundredth (speeds) of noise, of what swings, in every channel.
host_sim::Record record_of(const Sensors& sensors) {
  std::mt19937_64 random(7);
  const End end(random);
  const auto samples = static_cast<int>(kRate_Hz * kDuration_s);
  const double h = 1 / (kRate_Hz * kFiner);
  const double angle_noise = 1e-5, speed_noise = 6e-3;  // the end swings by 0.54 rad/s and some 10 mrad
  std::normal_distribution<double> normal;
  std::vector<double> values[3];
  State s;
  s.v[0] = s.v[1] = kSpeed_rad_s;
  for (int k = 0; k < samples; ++k) {
    const double t = k / kRate_Hz;
    const Turned now = end.at(t);
    const auto read = [&](bool angle, double x, double v) {
      return angle ? x + angle_noise * normal(random) : v + speed_noise * normal(random);
    };
    values[0].push_back(read(sensors.end_by_angle, now.angle, now.speed));
    for (int i = 0; i < 2; ++i) values[i + 1].push_back(read(sensors.inertias_by_angle, s.x[i], s.v[i]));
    for (int i = 0; i < kFiner; ++i) {
      const double at = t + i * h;
      s = stepped(s, h, end.at(at), end.at(at + h / 2), end.at(at + h), slope_of);
    }
  }
  host_sim::Record record;
  record.file = "shaft.csv", record.sample_period_s = 1 / kRate_Hz;
  for (int c = 0; c < 3; ++c) {
    const bool angle = c == 0 ? sensors.end_by_angle : sensors.inertias_by_angle;
    const std::string place = c == 0 ? "base" : std::to_string(c);
    host_sim::Channel made;
    made.name = angle ? "angle_" + place + "_rad" : "angular_velocity_" + place + "_rad_s";
    made.quantity = angle ? host_sim::Quantity::kDisplacement : host_sim::Quantity::kVelocity;
    made.dof = c == 0 ? rig_file::kBase : c, made.values = values[c];
    record.channels.push_back(made);
  }
  return record;
}

rig_file::RigModel rig() {
  rig_file::RigModel made;
  for (int i = 0; i < 2; ++i) {
    made.dofs.emplace_back();
    made.dofs.back().mass_kg.value = kInertia[i], made.dofs.back().rotating = true;
    rig_file::Link link;
    link.a = i + 1, link.b = i == 0 ? rig_file::kBase : i;
    link.stiffness_N_m.value = kStiffness[i], link.viscous_N_s_m.estimate = true;
    made.links.push_back(link);
  }
  return made;
}

// Speeds alone have no angle to start from, an angle of the end has turned 95 times by the end of the record: neither is the rig's.
TEST(TurningBase, TheRigIsWhatSwingsAboutItsSpeed) {
  for (const Sensors& sensors : {Sensors{false, false}, Sensors{true, false}, Sensors{true, true}}) {
    const diagnosis::Diagnosis d = diagnosis::diagnose(rig(), {record_of(sensors)}, {});
    EXPECT_EQ(said(d), "none") << sensors.end_by_angle << sensors.inertias_by_angle;
    ASSERT_EQ(d.baseline.parameters.size(), 2u) << sensors.end_by_angle << sensors.inertias_by_angle;
    for (const diagnosis::DetectionLimit& limit :
         d.minimum_detectable)  // how fast it is against the ground nobody asked
      EXPECT_EQ(limit.where.find("-0"), std::string::npos) << limit.effect << " on " << limit.where;
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(d.baseline.parameters[i].value, kViscous[i], 0.02 * kViscous[i]) << i;
      EXPECT_NEAR(d.baseline.parameters[i].value, kViscous[i], 4 * d.baseline.parameters[i].std) << i;
    }
  }
}

}  // namespace

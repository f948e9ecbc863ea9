// A building of two floors on a shaker table: nothing is measured but accelerations, and the table's may be read late.
// The plant here is its own: relative coordinates, fourth-order Runge-Kutta, friction as a steep smooth law.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "two_masses.hpp"

namespace {

using namespace two_masses;

constexpr double kTwoPi = 6.283185307179586;
constexpr double kRate_Hz = 200, kDuration_s = 60;
constexpr int kFiner = 16;
constexpr double kMass[] = {120, 90}, kStiffness[] = {9.0e4, 6.0e4}, kViscous[] = {60, 45};  // DOF or link 1 and 2

struct Building {
  double coulomb_N = 0, coulomb_link_2_N = 0;  // of link 1-base, of link 2-1
  double table_late_s = 0;
  double noise = 0.01;  // of each channel's rms
  uint64_t seed = 1;
};

// Sum of 60 sines of 0.5 to 12 Hz with random phases: rms about 1.5 m/s^2.
class Table {
 public:
  explicit Table(std::mt19937_64& random) {
    std::uniform_real_distribution<double> phase(0, kTwoPi), hertz(0.5, 12);
    for (int i = 0; i < 60; ++i) omega_.push_back(kTwoPi * hertz(random)), phase_.push_back(phase(random));
  }
  double acceleration(double t) const {
    double sum = 0;
    for (size_t i = 0; i < omega_.size(); ++i) sum += std::sin(omega_[i] * t + phase_[i]);
    return 1.5 * std::sqrt(2.0 / static_cast<double>(omega_.size())) * sum;
  }

 private:
  std::vector<double> omega_, phase_;
};

// Accelerations against the ground.
void floors(const Building& b, const State& s, double a[2]) {
  const double rate_2 = s.v[1] - s.v[0];
  const double below = kStiffness[0] * s.x[0] + kViscous[0] * s.v[0] + b.coulomb_N * std::tanh(s.v[0] / 5e-4);
  const double above =
      kStiffness[1] * (s.x[1] - s.x[0]) + kViscous[1] * rate_2 + b.coulomb_link_2_N * std::tanh(rate_2 / 5e-4);
  a[0] = (above - below) / kMass[0], a[1] = -above / kMass[1];
}

State slope_of(const Building& b, const State& s, double table) {
  State out;
  double a[2];
  floors(b, s, a);
  for (int i = 0; i < 2; ++i) out.x[i] = s.v[i], out.v[i] = a[i] - table;
  return out;
}

host_sim::Record record_of(const Building& b) {
  std::mt19937_64 random(b.seed);
  const Table table(random);
  const int samples = static_cast<int>(kRate_Hz * kDuration_s);
  const double h = 1 / (kRate_Hz * kFiner);
  std::vector<double> channel[3];
  State s;  // against the table
  for (int k = 0; k < samples; ++k) {
    const double t = k / kRate_Hz;
    double a[2];
    floors(b, s, a);
    channel[0].push_back(table.acceleration(t - b.table_late_s));
    channel[1].push_back(a[0]), channel[2].push_back(a[1]);
    for (int i = 0; i < kFiner; ++i) {
      const double at = t + i * h, middle = table.acceleration(at + h / 2);
      s = stepped(s, h, table.acceleration(at), middle, table.acceleration(at + h),
                  [&](const State& from, double shaken) { return slope_of(b, from, shaken); });
    }
  }
  host_sim::Record record;
  record.file = "building.csv", record.sample_period_s = 1 / kRate_Hz;
  constexpr const char* kNames[] = {"acceleration_base_m_s2", "acceleration_1_m_s2", "acceleration_2_m_s2"};
  std::normal_distribution<double> normal;
  for (int c = 0; c < 3; ++c) {
    double square = 0;
    for (double y : channel[c]) square += y * y;
    const double sigma = b.noise * std::sqrt(square / samples);
    for (double& y : channel[c]) y += sigma * normal(random);
    host_sim::Channel made;
    made.name = kNames[c], made.dof = c == 0 ? rig_file::kBase : c, made.quantity = host_sim::Quantity::kAcceleration;
    made.values = channel[c];
    record.channels.push_back(made);
  }
  return record;
}

rig_file::RigModel rig_of(bool springs_known) {
  rig_file::RigModel rig;
  for (int i = 0; i < 2; ++i) {
    rig.dofs.emplace_back();
    rig.dofs.back().mass_kg.value = kMass[i];
    rig_file::Link link;
    link.a = i + 1, link.b = i == 0 ? rig_file::kBase : i;
    link.stiffness_N_m = {kStiffness[i], false};
    if (!springs_known) link.stiffness_N_m = {0, true};
    link.viscous_N_s_m.estimate = true;
    rig.links.push_back(link);
  }
  return rig;
}

diagnosis::Diagnosis answer_to(const Building& b, bool springs_known = false) {
  return diagnosis::diagnose(rig_of(springs_known), {record_of(b)}, {});
}

void expect_near_truth(const diagnosis::ModelScore& model, const char* name, double truth, double within) {
  for (const diagnosis::Parameter& p : model.parameters)
    if (p.name == name) {
      EXPECT_NEAR(p.value, truth, within * truth) << name;
      EXPECT_NEAR(p.value, truth, 4 * p.std) << name;
      return;
    }
  ADD_FAILURE() << name << " is not there";
}

TEST(ShakerTable, ARightRigIsRightFromAccelerationsAlone) {
  for (const bool springs_known : {false, true}) {
    const diagnosis::Diagnosis d = answer_to({0, 0, 0, 0.01, springs_known ? 2u : 1u}, springs_known);
    EXPECT_EQ(d.verdict, diagnosis::Verdict::kNone) << said(d);
    expect_near_truth(d.baseline, "viscous[1-base]", kViscous[0], 0.05);
    expect_near_truth(d.baseline, "viscous[2-1]", kViscous[1], 0.05);
  }
}

TEST(ShakerTable, FrictionIsNamedAtItsLinkAndNeverTowardsTheGround) {
  for (const int link : {0, 1}) {
    Building b;
    (link == 0 ? b.coulomb_N : b.coulomb_link_2_N) = 12;
    const diagnosis::Diagnosis d = answer_to(b);
    const std::string place = link == 0 ? "link 1-base" : "link 2-1";
    ASSERT_EQ(d.causes.size(), 1u) << said(d);
    EXPECT_EQ(d.causes[0].where, place) << said(d);
    EXPECT_EQ(d.causes[0].effect, "missing_coulomb") << said(d);
    for (const diagnosis::NamedPlace& p : d.ambiguous_with) EXPECT_EQ(p.where, place);
    expect_near_truth(d.extended, link == 0 ? "missing_coulomb[1-base]" : "missing_coulomb[2-1]", 12, 0.05);
  }
}

// Four samples late, and one and a half early.
TEST(ShakerTable, ATableThatIsReadLateIsADelay) {
  for (const double late_s : {0.02, -0.0075}) {
    Building b;
    b.table_late_s = late_s, b.seed = 3;
    const diagnosis::Diagnosis d = answer_to(b);
    ASSERT_EQ(said(d), "explained, sensor_delay on channel acceleration_base_m_s2");
    ASSERT_EQ(d.causes[0].parameters.size(), 1u);
    EXPECT_NEAR(d.causes[0].parameters[0].value, late_s, 0.02 * std::abs(late_s));
    expect_near_truth(d.extended, "viscous[1-base]", kViscous[0], 0.05);
    ASSERT_EQ(d.extended_rig.channels.size(), 1u);
    EXPECT_NEAR(d.extended_rig.channels[0].delay_us, 1e6 * late_s, 0.02e6 * std::abs(late_s));
  }
}

}  // namespace

// A rig file with a mass of which one digit is mistyped, so that it follows its recording over no window.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/hidden_rig/draw.hpp"
#include "two_masses.hpp"

namespace {

using two_masses::said;
using two_masses::State;

constexpr double kMass_kg[2] = {1.5, 1.2}, kSpring_N_m[2] = {6000, 4000}, kDamper_N_s_m[2] = {6, 4};

// Sum of 40 tones between 2 and 20 Hz, phases drawn: both modes (6 and 14 Hz) are shaken. 3 N rms.
class Shaker {
 public:
  Shaker() {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> phase(0, 2 * M_PI);
    for (double& p : phases_) p = phase(random);
  }
  double force_N(double t) const {
    double sum = 0;
    for (int i = 0; i < 40; ++i) sum += 0.67 * std::sin(2 * M_PI * (2.03 + 0.4511 * i) * t + phases_[i]);
    return sum;
  }

 private:
  double phases_[40];
};

// Twelve seconds at 1 kHz; all three quantities of both masses with 1 % noise. `cubic_N_m3`: of the spring between them.
host_sim::Record recorded(double cubic_N_m3) {
  const Shaker shaker;
  const auto slope = [&](const State& s, double force) {
    const double u = s.x[1] - s.x[0], w = s.v[1] - s.v[0];
    const double between = kSpring_N_m[1] * u + cubic_N_m3 * u * u * u + kDamper_N_s_m[1] * w;
    State d;
    d.x[0] = s.v[0], d.x[1] = s.v[1];
    d.v[0] = (force + between - kSpring_N_m[0] * s.x[0] - kDamper_N_s_m[0] * s.v[0]) / kMass_kg[0];
    d.v[1] = -between / kMass_kg[1];
    return d;
  };
  host_sim::Record r;
  r.file = "shaken.csv", r.sample_period_s = 1e-3;
  std::vector<double> channel[7];
  State s;
  constexpr int kFiner = 4;
  for (int i = 0; i < 12000; ++i) {
    const State rate = slope(s, shaker.force_N(i * 1e-3));
    for (int d = 0; d < 2; ++d) {
      channel[3 * d].push_back(s.x[d]), channel[3 * d + 1].push_back(s.v[d]), channel[3 * d + 2].push_back(rate.v[d]);
    }
    channel[6].push_back(shaker.force_N(i * 1e-3));
    for (int k = 0; k < kFiner; ++k) {
      const double h = 1e-3 / kFiner, t = i * 1e-3 + k * h;
      s = two_masses::stepped(s, h, shaker.force_N(t), shaker.force_N(t + h / 2), shaker.force_N(t + h), slope);
    }
  }
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  const char* names[] = {"displacement_1_m", "velocity_1_m_s", "acceleration_1_m_s2",
                         "displacement_2_m", "velocity_2_m_s", "acceleration_2_m_s2",
                         "force_1_N"};
  const host_sim::Quantity quantities[] = {host_sim::Quantity::kDisplacement, host_sim::Quantity::kVelocity,
                                           host_sim::Quantity::kAcceleration};
  for (int c = 0; c < 7; ++c) {
    double square = 0;
    for (const double y : channel[c]) square += y * y / static_cast<double>(channel[c].size());
    for (double& y : channel[c]) y += 0.01 * std::sqrt(square) * normal(random);
    r.channels.push_back(
        {names[c], c < 6 ? quantities[c % 3] : host_sim::Quantity::kForce, c < 3 || c == 6 ? 1 : 2, channel[c]});
  }
  return r;
}

rig_file::RigModel rig_with(double second_mass_kg) {
  rig_file::RigModel rig;
  rig.dofs.resize(2), rig.links.resize(2);
  rig.dofs[0].mass_kg.value = kMass_kg[0], rig.dofs[1].mass_kg.value = second_mass_kg;
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround;
  rig.links[1].a = 1, rig.links[1].b = 2;
  for (int i = 0; i < 2; ++i)
    rig.links[static_cast<size_t>(i)].stiffness_N_m.value = kSpring_N_m[i],
    rig.links[static_cast<size_t>(i)].viscous_N_s_m.estimate = true;
  return rig;
}

void expect_mass_found(const diagnosis::Diagnosis& d, double error_kg) {
  EXPECT_NEAR(two_masses::value_of(d.extended, "mass_error[2]"), error_kg, 0.02 * kMass_kg[1]) << said(d);
  EXPECT_NEAR(two_masses::value_of(d.extended, "viscous[1-0]"), kDamper_N_s_m[0], 0.05 * kDamper_N_s_m[0]);
  EXPECT_NEAR(two_masses::value_of(d.extended, "viscous[1-2]"), kDamper_N_s_m[1], 0.05 * kDamper_N_s_m[1]);
}

// 1.2 kg written as 2.2, 0.2 and 5.2: its acceleration alone is up to six times as large as the rig file says. The dampers are
// then known about as well as from the right rig file.
TEST(GrossError, OfOneMassIsNamedAndTheNumbersAreThoseOfTheRightMass) {
  const host_sim::Record record = recorded(0);
  const diagnosis::Diagnosis right = diagnosis::diagnose(rig_with(kMass_kg[1]), {record}, {});
  EXPECT_EQ(said(right), "none");
  for (const double written_kg : {2.2, 0.2, 5.2}) {
    SCOPED_TRACE(written_kg);
    const diagnosis::Diagnosis d = diagnosis::diagnose(rig_with(written_kg), {record}, {});
    EXPECT_EQ(said(d), "explained, mass_error on dof 2");
    expect_mass_found(d, kMass_kg[1] - written_kg);
    const std::string advice = d.advice.empty() ? "" : d.advice[0];
    EXPECT_EQ(advice.rfind("mass 2 is " +
                               std::string(written_kg > 5   ? "5.2"
                                           : written_kg > 2 ? "2.2"
                                                            : "0.2") +
                               " kg",
                           0),
              0U)
        << advice;
    EXPECT_EQ(advice.find("decimal"), std::string::npos) << advice;
    for (const char* name : {"viscous[1-0]", "viscous[1-2]"}) {
      const double std_of_right = two_masses::parameter_of(right.extended, name).std;
      EXPECT_LT(two_masses::parameter_of(d.extended, name).std, 2 * std_of_right) << name;
      EXPECT_NEAR(two_masses::value_of(d.extended, name), two_masses::value_of(right.extended, name), 3 * std_of_right);
    }
  }
}

// Beside it the spring hardens: 8e7 u^3 at the 1.4 mm of u's rms is 4 % of k u.
TEST(GrossError, HidesNoSecondCause) {
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig_with(2.2), {recorded(8e7)}, {});
  const std::string words = said(d);
  EXPECT_NE(words.find("mass_error on dof 2"), std::string::npos) << words;
  EXPECT_NE(words.find("cubic_stiffness on link 1-2"), std::string::npos) << words;
  expect_mass_found(d, kMass_kg[1] - 2.2);
}

// Both springs in N/mm: no number of the rig file is near, and each comes back.
TEST(GrossError, OfAllSpringsIsNamedSpringBySpring) {
  rig_file::RigModel rig = rig_with(kMass_kg[1]);
  for (rig_file::Link& link : rig.links) link.stiffness_N_m.value /= 1000;
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {recorded(0)}, {});
  EXPECT_EQ(d.verdict, diagnosis::Verdict::kExplained) << said(d);
  ASSERT_EQ(d.causes.size(), 2U) << said(d);
  EXPECT_EQ(d.advice[0].rfind("spring 1-", 0), 0U) << d.advice[0];  // which of both is named first is open
  EXPECT_NE(d.advice[0].find(" N/m by the recording: a unit or a decimal point?"), std::string::npos) << d.advice[0];
  EXPECT_NEAR(two_masses::value_of(d.extended, "stiffness_error[1-0]"), 0.999 * kSpring_N_m[0], 0.01 * kSpring_N_m[0]);
  EXPECT_NEAR(two_masses::value_of(d.extended, "stiffness_error[1-2]"), 0.999 * kSpring_N_m[1], 0.01 * kSpring_N_m[1]);
  EXPECT_NEAR(two_masses::value_of(d.extended, "viscous[1-2]"), kDamper_N_s_m[1], 0.05 * kDamper_N_s_m[1]);
}

// Both links to the ground, mass 2 on nothing but its own: the rig file has a spring of 4000 N/m where there is none, and none
// between the masses, where there is one.
TEST(GrossError, OfALinkThatGoesElsewhereIsNamed) {
  rig_file::RigModel rig = rig_with(kMass_kg[1]);
  rig.links[1].a = 2, rig.links[1].b = rig_file::kGround;
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {recorded(0)}, {});
  const std::string words = said(d);
  EXPECT_NE(words.find("stiffness_error on link 2-0"), std::string::npos) << words;
  EXPECT_NE(words.find("stiffness_error on link 1-2"), std::string::npos) << words;
  EXPECT_NEAR(two_masses::value_of(d.extended, "stiffness_error[2-0]"), -kSpring_N_m[1], 0.02 * kSpring_N_m[1]);
  EXPECT_NEAR(two_masses::value_of(d.extended, "stiffness_error[1-2]"), kSpring_N_m[1], 0.02 * kSpring_N_m[1]);
  EXPECT_NEAR(two_masses::value_of(d.extended, "missing_viscous[1-2]"), kDamper_N_s_m[1], 0.1 * kDamper_N_s_m[1]);
}

// Masses and springs that are all three times too large: so they are where the force's reading is a third of the force.
TEST(GrossError, OfEverythingByOneFactorIsTheForces) {
  rig_file::RigModel rig = rig_with(kMass_kg[1]);
  for (rig_file::Dof& dof : rig.dofs) dof.mass_kg.value *= 3;
  for (rig_file::Link& link : rig.links) link.stiffness_N_m.value *= 3;
  const diagnosis::Diagnosis d = diagnosis::diagnose(rig, {recorded(0)}, {});
  EXPECT_EQ(said(d), "explained, sensor_gain on channel force_1_N");
  EXPECT_NEAR(two_masses::value_of(d.extended, "viscous[1-2]"), 3 * kDamper_N_s_m[1], 0.15 * kDamper_N_s_m[1]);
}

// A resonance of 99 g on four masses, velocities with 5 % noise: the rig file without it follows windows of a tenth of a period, and such
// windows know no number. With what the rows name windows are as long as a right rig's: it is not taken back as one that may be nought,
// and the numbers beside it are right.
TEST(GrossError, WhatIsFollowedOverATenthOfAPeriodIsJudgedOverLongWindows) {
  hidden_rig::Settings settings;
  settings.condition = "random_5pct", settings.sensors = "v", settings.hidden = "unmodelled_resonance";
  const hidden_rig::Draw draw = hidden_rig::make_draw(31200015, settings);
  const diagnosis::Diagnosis d = diagnosis::diagnose(draw.rig, draw.records, {});
  ASSERT_EQ(said(d), "explained, unmodelled_resonance on dof 1");
  for (const hidden_rig::TrueCoefficient& c : draw.coefficients) {
    const diagnosis::Parameter p = two_masses::parameter_of(d.extended, c.name);
    EXPECT_NEAR(p.value, c.value, 3 * p.std) << c.name;
  }
}

}  // namespace

// host_sim estimate on decays whose springs or dampers leave something open: where they rest, what is told beside it.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/programs/shared/swing.hpp"
#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;

// 30 swings of 100 samples, 0.9 of the amplitude from each to the next, about rest + b A^2.
std::vector<double> swings(double rest, double b) {
  std::vector<double> y;
  for (int k = 0; k < 3000; ++k) {
    const double amplitude = std::pow(0.9, k / 100.0);
    y.push_back(rest + b * amplitude * amplitude + amplitude * std::cos(2 * std::acos(-1.0) * k / 100.0));
  }
  return y;
}

// 40 swings of 5 cm about 0.3 m, 100 samples each, and at every fourth crest one value that is 3 cm too large. From sample to sample it moves ten times
// as fast as the swing ever does; over a quarter of a period the swing moves 7 cm.
TEST(Swing, SingleWrongValuesDoNotMoveItsCentre) {
  std::vector<double> y;
  for (int k = 0; k < 4000; ++k)
    y.push_back(0.3 + 0.05 * std::cos(2 * std::acos(-1.0) * k / 100.0) + (k % 400 == 0 && k > 0 ? 0.03 : 0.0));
  host_sim::Swing swing;
  swing.add(y);
  EXPECT_NEAR(swing.mean(), 0.3, 0.0005);
}

// Six swings and it lies still: what the parts of periods make of its centre is no place of rest. A slow decay about 0.3 has one.
TEST(Swing, ADecayOfAFewSwingsHasNoCentreButAnEnd) {
  std::vector<double> y;
  for (int k = 0; k < 6000; ++k) y.push_back(0.02 + std::exp(-k / 250.0) * std::cos(2 * std::acos(-1.0) * k / 150.0));
  host_sim::Swing swing;
  swing.add(y);
  const double off = std::fabs(swing.mean() - 0.02);
  EXPECT_GT(off, 0.02 * swing.rms());  // said to swing about there
  EXPECT_GT(2 * host_sim::strays_by(y), off);
  EXPECT_NEAR(host_sim::stays_at(y).value(), 0.02, 1e-6);
  EXPECT_LT(host_sim::strays_by(swings(0.3, 0)), 0.003);
  EXPECT_FALSE(host_sim::stays_at(swings(0.3, 0)));
}

TEST(CentreOfSmallSwings, IsWhereItMovesToAsTheyDie) {
  const std::vector<double> y = swings(0.3, -0.2);
  EXPECT_NEAR(host_sim::centre_of_small_swings({&y}).value(), 0.3, 0.01);
}

TEST(CentreOfSmallSwings, WhatHasComeToRestSaysNothing) {
  std::vector<double> y = swings(0.3, -0.2);
  y.insert(y.end(), 3000, y.back());
  EXPECT_NEAR(host_sim::centre_of_small_swings({&y}).value(), 0.3, 0.01);
}

TEST(CentreOfSmallSwings, OneAmplitudeDoesNotTell) {
  std::vector<double> y;
  for (int k = 0; k < 3000; ++k) y.push_back(0.3 + std::cos(2 * std::acos(-1.0) * k / 100.0));
  EXPECT_FALSE(host_sim::centre_of_small_swings({&y}).has_value());
}

// Let go at u rad; torque(u, w) of 1 kg m^2; 4000 steps a second, rows of the angle at `rate_Hz` beside `noise_rad`.
template <typename Torque>
std::string decay(double u, double rate_Hz, int samples, double zero_rad, double noise_rad, const Torque& torque) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::string text = "t_s,angle_1_rad\n";
  double w = 0;
  const int steps = static_cast<int>(std::ceil(4000 / rate_Hz));
  const double h = 1 / (rate_Hz * steps);
  for (int i = 0; i < samples; ++i) {
    char row[64];
    std::snprintf(row, sizeof row, "%.5f,%.7f\n", i / rate_Hz, zero_rad + u + noise_rad * normal(random));
    text += row;
    for (int k = 0; k < steps; ++k) u += 0.5 * h * w, w += h * torque(u, w), u += 0.5 * h * w;
  }
  return text;
}

const char* const kUneven =
    "schema = \"rig/1\"\nname = \"arm\"\n[[dof]]\ninertia_kg_m2 = 1.0\n[[link]]\nbetween = [1, 0]\n"
    "stiffness_N_m_rad = \"estimate\"\nviscous_N_m_s_rad = \"estimate\"\n[[link.effect]]\n"
    "kind = \"quadratic_stiffness\"\ncoefficient = \"estimate\"\n";

// A spring of 900 N m/rad that is softer on one side, -130 N m/rad^2, and a sensor whose zero is 0.11 rad from the rest: taken from there,
// the zero stood in k u and k2 u^2 alike, and a spring of 0.4 its size was told beside one that pulls the other way.
TEST_F(Estimate, AnUnevenSpringIsCountedFromWhereItRests) {
  workspace_.write("uneven.toml", kUneven);
  workspace_.write("uneven.csv", decay(0.8, 260, 5200, 0.11, 3e-4,
                                       [](double u, double w) { return -900 * u + 130 * u * u - 0.4 * w; }));
  const auto result = host_sim({"estimate", "--rig", "uneven.toml", "--data", "uneven.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  const auto out = json("out.json");
  EXPECT_NEAR(value(out, "stiffness[1-0]"), 900, 1);
  EXPECT_NEAR(value(out, "viscous[1-0]"), 0.4, 0.02);
  EXPECT_NEAR(value(out, "quadratic_stiffness[1-0]"), -130, 5);
}

nlohmann::json parameter(const nlohmann::json& estimate, const std::string& name) {
  for (const auto& one : estimate["parameters"])
    if (one["name"] == name) return one;
  return {};
}

// Eleven swings do not tell where that spring rests, and a zero that is not taken out leaves nothing to be known of it: an interval went out
// as 127 times the value to either side, VALID.
TEST_F(Estimate, OfWhatNothingIsKnownNothingIsValid) {
  workspace_.write("uneven.toml",
                   "schema = \"rig/1\"\nname = \"arm\"\n[[dof]]\ninertia_kg_m2 = 1.0\n[[link]]\nbetween = [1, 0]\n"
                   "stiffness_N_m_rad = \"estimate\"\nviscous_N_m_s_rad = \"estimate\"\ncoulomb_N_m = \"estimate\"\n"
                   "[[link.effect]]\nkind = \"quadratic_stiffness\"\ncoefficient = \"estimate\"\n");
  for (const double zero_rad : {-0.09, -0.06, -0.03, 0.03, 0.06, 0.1}) {
    for (const double start_rad : {1.0, 0.8, -0.8, -1.0}) {
      workspace_.write("uneven.csv", decay(start_rad, 260, 1000, zero_rad, 1e-3, [](double u, double w) {
                         return -298 * u + 60 * u * u - 0.6 * w - std::copysign(0.3, w);
                       }));
      const auto result = host_sim({"estimate", "--rig", "uneven.toml", "--data", "uneven.csv"});
      std::istringstream line(result.output.substr(result.output.find("quadratic_stiffness[1-0]")));
      std::string name, unit, per, status;
      double number = 0, low = 0, high = 0;
      line >> name >> number >> low >> high >> unit >> per >> status;
      EXPECT_FALSE(status.empty()) << result.output;
      EXPECT_FALSE(status == "VALID" && high - low > 100 * std::fabs(number)) << result.output;
    }
  }
}

const char* const kOpenDamping =
    "schema = \"rig/1\"\nname = \"pendulum\"\n[[dof]]\ninertia_kg_m2 = 1.0\n[[link]]\nbetween = [1, 0]\n"
    "gravity_torque_N_m = \"estimate\"\nviscous_N_m_s_rad = \"estimate\"\ncoulomb_N_m = \"estimate\"\n";

// A light pendulum, G = 15.1 N m, loses a tenth of its swing: that is viscous or dry. The torque is known to a fraction of a percent
// whichever it is; it went out as 15.1 +- 1950.
TEST_F(Estimate, WhatStandsBesideAnOpenQuestionIsToldAllTheSame) {
  workspace_.write("light.toml", kOpenDamping);
  workspace_.write("light.csv",
                   decay(0.08, 40, 1200, 0, 4e-4, [](double u, double w) { return -15.1 * std::sin(u) - 0.006 * w; }));
  const auto result = host_sim({"estimate", "--rig", "light.toml", "--data", "light.csv", "--json", "out.json"});
  const auto out = json("out.json");
  ASSERT_FALSE(out.is_discarded()) << result.errors;
  const auto torque = parameter(out, "gravity_torque[1-0]");
  const double low = torque["ci95"][0], high = torque["ci95"][1];
  EXPECT_LT(low, 15.1);
  EXPECT_GT(high, 15.1);
  EXPECT_LT(high - low, 1.5) << result.output;
}

}  // namespace

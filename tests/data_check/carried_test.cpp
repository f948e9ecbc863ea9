// Spikes of a displacement that columns beside it were computed from.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/data_check/data_check.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;
using host_sim::data_check::check;
using host_sim::data_check::Finding;
using host_sim::data_check::Report;
using host_sim::data_check::Weight;

constexpr double kTurn = 2 * M_PI * 1.35, kStep_s = 0.01;
constexpr int kSamples = 8000;

double swing(int i) { return 0.08 * std::exp(-0.03 * kStep_s * i) * std::sin(kTurn * kStep_s * i); }

// Central differences over so many samples.
std::vector<double> rate(const std::vector<double>& y, size_t span) {
  std::vector<double> v(y.size(), 0.0);
  for (size_t i = span; i + span < y.size(); ++i)
    v[i] = (y[i + span] - y[i - span]) / (2.0 * static_cast<double>(span) * kStep_s);
  return v;
}

// A decay of 80 s at 100 Hz with nine glitches of 5 cm. They are 9 * 0.05^2 = 0.0225 of the sum of squares of the displacement,
// 8000 * 0.08^2 / 2 / 4.8 = 5.3: 0.4 %. Two central differences over 4 samples each make 1, -2 and 1 times 0.05 m / 16 / (0.01 s)^2 =
// 31 m/s^2 of a glitch: 9 * 5860 = 53,000, where the swing has 5.3 * (8.48 / s)^4 = 27,000.
Record record(bool glitches, bool computed) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 2e-5);
  Record record;
  record.file = "made.csv", record.sample_period_s = kStep_s;
  std::vector<double> x, clean;
  for (int i = 0; i < kSamples; ++i) {
    clean.push_back(swing(i) + noise(random));
    x.push_back(clean.back() + (glitches && i % 937 == 300 ? 0.05 : 0.0));
  }
  const std::vector<double> v = rate(computed ? x : clean, 2);
  record.channels = {{"displacement_1_m", Quantity::kDisplacement, 1, x},
                     {"velocity_1_m_s", Quantity::kVelocity, 1, v},
                     {"acceleration_1_m_s2", Quantity::kAcceleration, 1, rate(v, 2)}};
  return record;
}

const Finding* spikes_of_displacement(const Report& report) {
  for (const Finding& finding : report.records[0].channels[0].findings)
    if (finding.kind == "spikes") return &finding;
  return nullptr;
}

TEST(Carried, SpikesHarmTheColumnsThatWereComputedFromTheirs) {
  const Report report = check({record(true, true)}, nullptr);
  const Finding* finding = spikes_of_displacement(report);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->weight, Weight::kFault);
  EXPECT_NE(finding->detail.find("and acceleration_1_m_s2 jumps with them"), std::string::npos) << finding->detail;
}

// An accelerometer of its own knows nothing of them.
TEST(Carried, SpikesDoNotHarmSensorsOfTheirOwn) {
  const Report report = check({record(true, false)}, nullptr);
  const Finding* finding = spikes_of_displacement(report);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->weight, Weight::kDoubt);
  EXPECT_NE(finding->detail.find("too small to matter much"), std::string::npos) << finding->detail;
  const Report clean = check({record(false, true)}, nullptr);
  EXPECT_EQ(spikes_of_displacement(clean), nullptr);
}

}  // namespace

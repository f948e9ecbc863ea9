// Blows of a force that the motion shows, and spikes of its sensor, which it does not.
#include "host_sim/data_check/spikes/answered.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "host_sim/data_check/data_check.hpp"

namespace {

using namespace host_sim::data_check;
using host_sim::Channel;
using host_sim::Quantity;
using host_sim::Record;

// 2 kg, 10 ms: 10 N for one sample are 0.1 N s, so 0.05 m/s. What the velocity does besides: 1 mm/s up and down.
Record one_blow(double change_m_s) {
  Record record;
  record.sample_period_s = 0.01;
  Channel force{"force_1_N", Quantity::kForce, 1, std::vector<double>(60, 0.0)};
  Channel velocity{"velocity_1_m_s", Quantity::kVelocity, 1, std::vector<double>(60, 0.0)};
  force.values[30] = 10.0;
  for (size_t i = 0; i < 60; ++i)
    velocity.values[i] = (i > 30 ? change_m_s : 0.0) + (i % 3 == 0 ? 0.001 : i % 3 == 1 ? -0.001 : 0.0);
  record.channels = {force, velocity};
  return record;
}

TEST(AnsweredBlow, ChangesTheVelocityByItsMomentumOverTheMass) {
  const Record record = one_blow(0.05);
  const Answered all = answered(record, record.channels[0], {{30, 1, 10.0}}, 0.01 / 2.0);
  EXPECT_NEAR(all.share, 1.0, 0.045);  // two samples of 1 mm/s beside 50
  EXPECT_GT(all.std, 0.0);
  EXPECT_LT(all.std, 0.04);
}

TEST(AnsweredBlow, IsNoneWhereTheVelocityGoesOn) {
  const Record record = one_blow(0.0);
  const Answered none = answered(record, record.channels[0], {{30, 1, 10.0}}, 0.01 / 2.0);
  EXPECT_NEAR(none.share, 0.0, 0.045);
}

TEST(AnsweredBlow, IsNotKnownWithoutMassOrMotion) {
  Record record = one_blow(0.0);
  EXPECT_EQ(answered(record, record.channels[0], {{30, 1, 10.0}}, 0.0).std, 0.0);
  record.channels.pop_back();
  EXPECT_EQ(answered(record, record.channels[0], {{30, 1, 10.0}}, 0.005).std, 0.0);
}

// 1 kg on 5000 N/m and 4 N s/m, 8 s at 1 kHz, driven by six sines of 2 to 40 Hz and every 211th sample by twelve times their rms, which acts or
// is the sensor's alone. Steps of a twentieth of a sample.
Record driven(bool acts, const std::string& sensors, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(0.0, 2.0 * M_PI), hertz(2.0, 40.0);
  std::normal_distribution<double> noise;
  double phase[6], omega[6];
  for (int i = 0; i < 6; ++i) phase[i] = turn(random), omega[i] = 2.0 * M_PI * hertz(random);
  const auto smooth = [&](double t) {
    double f = 0.0;
    for (int i = 0; i < 6; ++i) f += std::sin(omega[i] * t + phase[i]);
    return f;
  };
  std::vector<double> f, x, v, a;
  double position = 0.0, speed = 0.0;
  for (int k = 0; k < 8000; ++k) {
    const double blow = k % 211 == 97 ? (k % 2 ? 12.0 : -12.0) * std::sqrt(3.0) : 0.0;
    f.push_back(smooth(1e-3 * k) + blow), x.push_back(position), v.push_back(speed);
    for (int i = 0; i < 20; ++i) {
      const double force = smooth(1e-3 * k + 5e-5 * i) + (acts ? blow : 0.0);
      const double acceleration = force - 5000.0 * position - 4.0 * speed;
      if (i == 0) a.push_back(acceleration);
      speed += 5e-5 * acceleration, position += 5e-5 * speed;
    }
  }
  Record record;
  record.sample_period_s = 1e-3;
  const auto add = [&](const char* name, Quantity quantity, std::vector<double> y) {
    double square = 0.0;
    for (const double value : y) square += value * value / static_cast<double>(y.size());
    for (double& value : y) value += 0.003 * std::sqrt(square) * noise(random);
    record.channels.push_back({name, quantity, 1, y});
  };
  add("force_1_N", Quantity::kForce, f);
  if (sensors.find('x') != std::string::npos) add("displacement_1_m", Quantity::kDisplacement, x);
  if (sensors.find('v') != std::string::npos) add("velocity_1_m_s", Quantity::kVelocity, v);
  if (sensors.find('a') != std::string::npos) add("acceleration_1_m_s2", Quantity::kAcceleration, a);
  return record;
}

bool has_spikes(const Record& record) {
  rig_file::RigModel rig;
  rig.dofs.resize(1);
  rig.dofs[0].mass_kg.value = 1.0;
  const Report report = check({record}, &rig);
  for (const Finding& finding : report.records[0].channels[0].findings)
    if (finding.kind == "spikes" && finding.weight == Weight::kFault) return true;
  return false;
}

TEST(AnsweredBlow, TellsSpikesOfAForceFromBlows) {
  for (const char* sensors : {"x", "v", "a", "xva"})
    for (unsigned seed = 1; seed <= 8; ++seed) {
      EXPECT_TRUE(has_spikes(driven(false, sensors, seed))) << sensors << ", seed " << seed;
      EXPECT_FALSE(has_spikes(driven(true, sensors, seed))) << sensors << ", seed " << seed;
    }
}

}  // namespace

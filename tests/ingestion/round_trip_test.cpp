// Codes packed into sensor frames, logged as candump writes them, and read again, in each wiring.
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "firmware/can_protocol/streams/sensor_frames.hpp"
#include "host_sim/can_log/log_writer.hpp"
#include "host_sim/ingestion/sensor_log/sensor_log_reader.hpp"
#include "tests/ingestion/rigs.hpp"

namespace {

using firmware::SensorWiring;

constexpr int kSamples = 300;

class RoundTrip : public testing::TestWithParam<SensorWiring> {};

// Two DOFs: DOF 1 with force and displacement, DOF 2 with velocity and acceleration; 16-bit codes suit every wiring.
// unit_per_code 1: the values are the codes.
TEST_P(RoundTrip, EveryCodeComesBack) {
  firmware::SensorPlan plan;
  if (GetParam() == SensorWiring::kPairs) {
    for (const auto& [node, quantity] : {std::pair{0, 0}, {0, 1}, {1, 2}, {1, 3}})
      firmware::add_to_pairs(plan, node, static_cast<firmware::Quantity>(quantity));
  }
  if (GetParam() != SensorWiring::kPairs) plan.wiring[0] = plan.wiring[1] = GetParam();
  plan.expected[0] = GetParam() == SensorWiring::kFd ? 1 : 3;
  plan.expected[1] = GetParam() == SensorWiring::k24 ? 3 : 1;
  if (GetParam() == SensorWiring::kPairs) plan.expected[0] = 1;
  std::mt19937 random(1);
  std::vector<firmware::RawSample> samples(kSamples);
  std::ostringstream log;
  can_log::LogWriter writer(log, "vcan0", can_log::kSimulatedEpoch_s);
  for (int i = 0; i < kSamples; ++i) {
    firmware::RawSample& sample = samples[static_cast<size_t>(i)];
    sample.sequence = 65400 + static_cast<uint32_t>(i);  // passes the end of 16 bits
    for (const auto& [node, quantity] : {std::pair{0, 0}, {0, 1}, {1, 2}, {1, 3}})
      sample.code[node][quantity] = static_cast<int32_t>(random() % 65536u) - 32768;
    firmware::CanFrame messages[firmware::kMaxSensorFrames];
    const int count = firmware::pack_sample(plan, sample, messages);
    for (int m = 0; m < count; ++m) writer.write(messages[m], static_cast<uint64_t>(i) * 500000u);
  }

  std::string channels;
  for (const char* name : {"force_1_N", "displacement_1_m", "velocity_2_m_s", "acceleration_2_m_s2"})
    channels += std::string("[[channel]]\nname = \"") + name + "\"\nunit_per_code = 1.0\n";
  const auto record = host_sim::parse_sensor_log(log.str(), "s.log", test_rigs::dampers(2, 0, channels));
  ASSERT_EQ(record.samples(), static_cast<size_t>(kSamples));
  EXPECT_NEAR(record.sample_period_s, 5e-4, 1e-12);
  for (const host_sim::Channel& channel : record.channels)
    for (size_t i = 0; i < record.samples(); ++i)
      EXPECT_EQ(channel.values[i], samples[i].code[channel.dof - 1][static_cast<int>(channel.quantity)]);
}

INSTANTIATE_TEST_SUITE_P(Wirings, RoundTrip,
                         testing::Values(SensorWiring::k16, SensorWiring::k24, SensorWiring::kFd,
                                         SensorWiring::kPairs));

}  // namespace

// The state from which a record is simulated, where its first samples do not show it.
#include "host_sim/plant/motion/fitted_start.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/plant/rigs.hpp"

namespace {

using host_sim::Quantity;
using plant_test::oscillator;

host_sim::Record record_of(Quantity quantity, std::vector<double> values) {
  host_sim::Record record;
  record.sample_period_s = 1e-3;
  record.channels.push_back({"", quantity, 1, std::move(values)});
  return record;
}

host_sim::InitialState start_of(const rig_file::RigModel& rig, const host_sim::Record& record, size_t sample) {
  const host_sim::FreeRun run(rig, record);
  return host_sim::fitted_start(run, rig, record, sample, record.samples() - sample);
}

// 1 kg on 100 N/m swings with 10 rad/s: x = cos 10 t. Of its rate alone, -10 sin 10 t, a sample shows no displacement; the run of the
// following ones does. At 0.4 s x is cos 4 = -0.6536, v is -10 sin 4 = 7.568.
TEST(FittedStart, FindsTheDisplacementThatIsNotMeasured) {
  std::vector<double> rate;
  for (int k = 0; k < 4001; ++k) rate.push_back(-10.0 * std::sin(0.01 * k));
  const auto record = record_of(Quantity::kVelocity, rate);
  const auto rig = oscillator(1.0, 100.0);
  EXPECT_DOUBLE_EQ(host_sim::measured_state(rig, record, 400).x_m[0], 0.0);
  const auto there = start_of(rig, record, 400);
  EXPECT_NEAR(there.x_m[0], std::cos(4.0), 1e-4);
  EXPECT_NEAR(there.v_m_s[0], -10.0 * std::sin(4.0), 1e-3);
  EXPECT_NEAR(start_of(rig, record, 0).x_m[0], 1.0, 1e-4);  // where the run from the measured state stands still
}

// The same of the displacement: read to +-1 mm (every other sample), the slope of the first is wrong by 2 mm in 1 ms.
TEST(FittedStart, IsNotTheSlopeOfNoise) {
  std::vector<double> place;
  for (int k = 0; k < 4001; ++k) place.push_back(std::cos(0.01 * k) + (k % 2 ? 1e-3 : -1e-3));
  const auto record = record_of(Quantity::kDisplacement, place);
  const auto rig = oscillator(1.0, 100.0);
  EXPECT_GT(std::abs(host_sim::measured_state(rig, record, 0).v_m_s[0]), 1.0);
  const auto start = start_of(rig, record, 0);
  EXPECT_NEAR(start.x_m[0], 1.0, 1e-4);
  EXPECT_NEAR(start.v_m_s[0], 0.0, 1e-3);
}

// What is measured without any noise stays as it is, to the last bit.
TEST(FittedStart, LeavesARightStateAlone) {
  std::vector<double> place, rate;
  for (int k = 0; k < 2001; ++k) place.push_back(std::cos(0.01 * k)), rate.push_back(-10.0 * std::sin(0.01 * k));
  auto record = record_of(Quantity::kDisplacement, place);
  record.channels.push_back({"", Quantity::kVelocity, 1, rate});
  const auto start = start_of(oscillator(1.0, 100.0), record, 300);
  EXPECT_DOUBLE_EQ(start.x_m[0], place[300]);
  EXPECT_DOUBLE_EQ(start.v_m_s[0], rate[300]);
}

// Friction of 5 N holds the mass at 10 mm, where its spring pulls with 1 N and the drive with 2 N at the most: it stays there.
TEST(FittedStart, ARigThatSticksGoesOnSticking) {
  std::vector<double> place, force;
  for (int k = 0; k < 2001; ++k) {
    place.push_back(0.01 + (k % 2 ? 1e-6 : -1e-6));
    force.push_back(2.0 * std::sin(0.02 * k));
  }
  auto record = record_of(Quantity::kDisplacement, place);
  record.channels.push_back({"", Quantity::kForce, 1, force});
  const auto run = host_sim::run_beside(oscillator(1.0, 100.0, 0.0, 5.0), record, {0});
  for (double x : run.find(Quantity::kDisplacement, 1)->values) EXPECT_NEAR(x, 0.01, 3e-6);
}

// Each stretch begins in its own state: the swing of above, known by its rate, all along.
TEST(FittedStart, EveryStretchHasItsOwn) {
  std::vector<double> rate;
  for (int k = 0; k < 3001; ++k) rate.push_back(-10.0 * std::sin(0.01 * k));
  const auto run = host_sim::run_beside(oscillator(1.0, 100.0), record_of(Quantity::kVelocity, rate), {0, 1100, 2000});
  const auto& x = run.find(Quantity::kDisplacement, 1)->values;
  ASSERT_EQ(x.size(), 3001u);
  for (size_t k = 0; k < 3001; k += 50) EXPECT_NEAR(x[k], std::cos(0.01 * static_cast<double>(k)), 1e-3) << k;
}

}  // namespace

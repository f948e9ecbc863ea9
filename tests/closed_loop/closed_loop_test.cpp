// The controller drives the simulated rig through the hal interfaces and says on CAN what its dampers are.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/fake/fake_can_bus.hpp"
#include "hal/fake/fake_configuration_store.hpp"
#include "tests/closed_loop/loop.hpp"

namespace {

using namespace closed_loop;

void expect_estimates(Loop& loop, const std::vector<double>& truth, double relative_limit) {
  for (size_t i = 0; i < truth.size(); ++i) {
    const firmware::EstimateRecord record = loop.record(static_cast<int>(i));
    EXPECT_NEAR(Loop::number(record) / truth[i], 1.0, relative_limit) << "parameter " << i;
    EXPECT_EQ(record.status, firmware::EstimateStatus::kValid) << "parameter " << i;
  }
}

TEST(ClosedLoop, OneDofSineAtThreeLevels) {
  RigSettings settings;
  settings.plant = chain({2.0}, 2.0e4, {15.0, 15.0}, 2.0);
  settings.plant.links.pop_back();  // one link to ground: 2 kg, 2e4 N/m (15.9 Hz), 15 N s/m, 2 N
  firmware::ExcitationProgramme programme;
  programme.level_count = 3;  // two unknowns: two equations would leave nothing to check them with
  programme.levels[0] = sine_level(0.2, 20.0, 50);
  programme.levels[1] = sine_level(0.5, 20.0, 50);
  programme.levels[2] = sine_level(0.8, 20.0, 50);
  firmware::WindowConfiguration window;
  window.mode = firmware::WindowMode::kWholeCycles;
  window.cycle_samples_numerator = 50;
  Loop loop(settings, programme, window);
  ASSERT_TRUE(loop.run_until(ControllerMode::kDone));
  EXPECT_FALSE(loop.controller->latched_alarm());
  EXPECT_EQ(loop.can.count(0x081), 0u);
  EXPECT_FALSE(loop.rig.relay.active());
  expect_estimates(loop, {15.0, 2.0}, 0.001);
}

TEST(ClosedLoop, ThreeDofRandomAtTwoLevels) {
  RigSettings settings;
  settings.plant = chain({1.5, 1.3, 2.0}, 1.0e4, {20.0, 20.0, 20.0, 20.0}, 1.0);
  firmware::ExcitationProgramme programme;
  programme.level_count = 2;
  for (int i = 0; i < 2; ++i) {
    auto& level = programme.levels[i];
    level.kind = firmware::ExcitationKind::kRandomBand;
    level.amplitude = part(i == 0 ? 0.1 : 0.25);
    level.phase_step = step_of(5.0);
    level.high_phase_step = step_of(50.0);
    level.seed = static_cast<uint32_t>(i + 1);
    level.ramp_samples = 200;
    level.measure_samples = 20000;
  }
  Loop loop(settings, programme);
  ASSERT_TRUE(loop.run_until(ControllerMode::kDone));
  expect_estimates(loop, {20.0, 1.0, 20.0, 20.0, 20.0}, 0.002);
}

TEST(ClosedLoop, FreeDecayAfterAPull) {
  RigSettings settings;
  settings.plant = chain({2.0}, 2.0e4, {6.0, 6.0}, 0.5);
  settings.plant.links.pop_back();
  firmware::ExcitationProgramme programme;
  programme.level_count = 2;
  for (int i = 0; i < 2; ++i) {
    auto& level = programme.levels[i];
    level.kind = firmware::ExcitationKind::kFreeDecay;
    level.amplitude = part(i == 0 ? 0.9 : 0.4);
    level.ramp_samples = 500;
    level.settle.block_samples = 63;
    level.settle.floor_code = 50;
    level.settle_limit_samples = 20000;
    level.measure_samples = 800;
  }
  Loop loop(settings, programme);
  ASSERT_TRUE(loop.run_until(ControllerMode::kFreeDecay));
  EXPECT_NEAR(loop.rig.displacement_m(1), 90.0 / 2.0e4, 0.6 / 2.0e4);  // pulled to F / k, friction apart
  ASSERT_TRUE(loop.run_until(ControllerMode::kDone));
  expect_estimates(loop, {6.0, 0.5}, 0.01);
}

// The settling time is found, not given: a rig with a tenth of the damping takes that much longer.
TEST(ClosedLoop, SettlingFollowsTheRig) {
  int waited[2] = {};
  for (int i = 0; i < 2; ++i) {
    RigSettings settings;
    settings.plant = chain({2.0}, 2.0e4, {i == 0 ? 40.0 : 4.0, 0.0}, 0.0);
    settings.plant.links.pop_back();
    firmware::ExcitationProgramme programme;
    programme.level_count = 1;
    programme.levels[0] = sine_level(0.1, 20.0, 50);
    Loop loop(settings, programme);
    ASSERT_TRUE(loop.run_until(ControllerMode::kSettle));
    while (loop.controller->mode() == ControllerMode::kSettle) {
      loop.run_sample();
      ++waited[i];
    }
    EXPECT_FALSE(loop.controller->excitation().unsettled());
  }
  // Transients decay as exp(-c t / 2m): time constants of 100 ms and 1 s. The four blocks compared take 400 ms by
  // themselves.
  EXPECT_LT(waited[0], 1200);
  EXPECT_GT(waited[1], waited[0] + 1000);
}

TEST(ClosedLoop, EmergencyStopLetsTheRigCoastOut) {
  RigSettings settings;
  settings.plant = chain({2.0}, 2.0e4, {15.0, 0.0}, 2.0);
  settings.plant.links.pop_back();
  firmware::ExcitationProgramme programme;
  programme.level_count = 1;
  programme.levels[0] = sine_level(0.8, 20.0, 50);
  Loop loop(settings, programme);
  ASSERT_TRUE(loop.run_until(ControllerMode::kIntegrate));
  loop.stop_line.set(true, loop.rig.now_ns());
  loop.controller->step();
  EXPECT_EQ(loop.rig.drive_q31(), 0);
  EXPECT_FALSE(loop.rig.relay.active());
  for (int i = 0; i < 20; ++i) loop.run_sample();
  EXPECT_NEAR(loop.rig.force_N(), 0.0, 1e-4);  // 20 ms: the amplifier's two lags of 1 ms are long over
  for (int i = 0; i < 3000; ++i) loop.run_sample();
  EXPECT_LT(std::fabs(loop.rig.displacement_m(1)),
            2.0 / 2.0e4 + 1e-6);  // at rest within the friction's dead zone F / k
  ASSERT_NE(loop.can.last(0x081), nullptr);
  EXPECT_EQ(loop.can.last(0x081)->data[0] | loop.can.last(0x081)->data[1] << 8, 0xFF01);
}

}  // namespace

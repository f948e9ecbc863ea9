// What starts the drive, what starts it again after a stop, and what keeps it from starting.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;
using bench::kEmergencyId;
using firmware::AlarmCause;
using firmware::ControllerMode;

TEST(Faults, EmergencyStopActsBeforeTheNextSampleIsTaken) {
  Bench bench(bench::driving());
  bench.drive_into(ControllerMode::kIntegrate);
  const uint64_t writes = bench.drive.writes();
  bench.stop_line.set(true, 0);
  bench.step();  // the same millisecond: no sample has come since
  EXPECT_TRUE(bench.dead());
  EXPECT_EQ(bench.drive.writes(), writes + 1);  // one command: zero
}

TEST(Faults, EmergencyStopHoldsWhilePressedAndIsToldOnce) {
  Bench bench(bench::driving());
  bench.drive_into(ControllerMode::kRamp);
  bench.stop_line.set(true, 0);
  bench.run_samples(1000);
  EXPECT_EQ(bench.can.count(kEmergencyId), 1u);
  EXPECT_FALSE(bench.controller->reset());
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kEmergencyStop);
  EXPECT_EQ(bench.controller->trips(), 1u);
}

TEST(Faults, EmergencyStopTakesOverFromAnotherFault) {
  Bench bench(bench::driving());
  bench.drive_into(ControllerMode::kRamp);
  bench.sequence += 5;
  bench.run_sample();
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kFault);
  bench.stop_line.set(true, 0);
  bench.run_sample();
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kEmergencyStop);
  EXPECT_EQ(bench.can.count(kEmergencyId), 2u);
}

TEST(Faults, EmergencyStopWhenIdleOrListening) {
  for (const auto& configuration : {bench::driving(), bench::listening()}) {
    Bench bench(configuration);
    bench.run_samples(10);
    bench.stop_line.set(true, 0);
    bench.run_sample();
    EXPECT_EQ(bench.controller->mode(), ControllerMode::kEmergencyStop);
    EXPECT_FALSE(bench.controller->start());
  }
}

TEST(Faults, PressedAtBootNeverStarts) {
  Bench bench(bench::driving_at_boot());
  bench.stop_line.set(true, 0);
  bench.run_samples(50);
  EXPECT_EQ(bench.relay.changes(), 0u);
  EXPECT_TRUE(bench.dead());
}

// A reset clears the reason; only a start moves the rig.
TEST(Faults, AResetAfterAPressAtBootStartsNothing) {
  Bench bench(bench::driving_at_boot());
  bench.stop_line.set(true, 0);
  bench.run_samples(50);
  bench.stop_line.set(false, 0);
  bench.run_samples(5);
  EXPECT_TRUE(bench.controller->reset());
  bench.run_samples(50);
  EXPECT_EQ(bench.relay.changes(), 0u);
  EXPECT_TRUE(bench.dead());
  EXPECT_TRUE(bench.controller->start());
  EXPECT_TRUE(bench.run_until(ControllerMode::kIntegrate));
}

// The board's program says so after a run that did not end well.
TEST(Faults, AStartByItselfCanBeHeldBack) {
  Bench bench(bench::driving_at_boot());
  bench.controller->wait_for_start();
  bench.run_samples(50);
  EXPECT_EQ(bench.relay.changes(), 0u);
  EXPECT_TRUE(bench.controller->start());
  EXPECT_TRUE(bench.run_until(ControllerMode::kIntegrate));
}

// The converter refuses at the very sample with which the measurement begins.
TEST(Faults, NoLevelBeginsWithTheSampleThatStoppedTheRig) {
  int begins_at = 0;
  {
    Bench bench(bench::driving());
    bench.step();
    ASSERT_TRUE(bench.controller->start());
    while (bench.controller->mode() != ControllerMode::kIntegrate && begins_at < 20000) bench.run_sample(), ++begins_at;
  }
  Bench bench(bench::driving());
  bench.step();
  ASSERT_TRUE(bench.controller->start());
  bench.run_samples(begins_at - 1);
  bench.drive.refuse(true);
  bench.run_sample();
  bench.drive.refuse(false);
  ASSERT_EQ(bench.controller->latched_alarm().cause, AlarmCause::kDriveNotTaken);
  const uint32_t taken = bench.controller->core().health().samples;
  bench.run_samples(1000);
  EXPECT_EQ(bench.controller->core().health().samples, taken);
}

// Stopped at over 2^27, four times the slew limit of 2^25, which the random level keeps from sample to sample. The output has been
// zero since, and the new start begins there: no step. Against the command before the stop its first one was 2^27 down.
TEST(Faults, AStartAfterAStopWhileDrivingIsNoStep) {
  auto configuration = bench::driving();
  configuration.programme.level_count = 1;
  firmware::ExcitationLevel& level = configuration.programme.levels[0];
  level.kind = firmware::ExcitationKind::kRandomBand;
  level.amplitude = firmware::Drive::from_raw(1 << 27);
  level.phase_step = 1 << 20;
  level.high_phase_step = 1 << 24;  // 2^-8 of the rate: from sample to sample 2 pi / 256 of the value at most
  configuration.programme.limits.step_per_sample = firmware::Drive::from_raw(1 << 25);
  Bench bench(configuration);
  bench.drive_into(ControllerMode::kIntegrate);
  while (std::abs(bench.drive.drive_q31()) < 1 << 27) bench.run_sample();
  bench.stop_line.pulse(0);
  bench.run_sample();
  ASSERT_TRUE(bench.dead());
  bench.run_samples(5);
  ASSERT_TRUE(bench.controller->reset());
  ASSERT_TRUE(bench.controller->start());
  bench.run_samples(20);
  EXPECT_FALSE(bench.controller->latched_alarm());
  EXPECT_TRUE(bench.relay.active());
}

// Eight levels add up. A ninth would not be measured: START says so, until RESET forgets them.
TEST(Faults, NoLevelBeginsThatWouldNotBeMeasured) {
  auto configuration = bench::listening();
  configuration.node.listen_on_command = true;
  Bench bench(configuration);
  bench.run_samples(3);
  for (int level = 0; level < firmware::kMaxLevels; ++level) {
    EXPECT_TRUE(bench.controller->start()) << level;
    bench.run_samples(50);
    bench.controller->stop();
    bench.run_samples(5);
  }
  EXPECT_FALSE(bench.controller->start());
  bench.network_command(1, 0);
  bench.run_samples(5);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kIdle);
  EXPECT_TRUE(bench.controller->reset());
  EXPECT_TRUE(bench.controller->start());
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kIntegrate);
}

}  // namespace

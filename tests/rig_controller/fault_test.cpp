// Every cause that must stop the drive: zero and relay off in the same step, told once, latched until reset. And the
// causes that must not.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <string>

#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;
using bench::kEmergencyId;
using firmware::AlarmCause;
using firmware::ControllerMode;

constexpr uint32_t kStatusId = 0x181, kHeartbeatId = 0x701;

uint16_t emergency_code(const hal::CanFrame& frame) {
  return static_cast<uint16_t>(frame.data[0] | frame.data[1] << 8);
}

uint16_t faults_of(const hal::CanFrame& frame) { return static_cast<uint16_t>(frame.data[0] | frame.data[1] << 8); }

struct Case {
  std::string name;
  AlarmCause cause;
  uint16_t code;  // of the emergency frame
  int status_bit;
  std::function<void(Bench&)> hurt;  // before the sample
  std::function<void(Bench&)> heal;
  int samples_to_trip;  // within how many sample periods it must act
};

void silent(Bench& bench) { bench.source.fail(hal::SampleFailure::kSilent); }

std::vector<Case> cases() {
  return {
      {"emergency stop", AlarmCause::kEmergencyStop, 0xFF01, 0, [](Bench& b) { b.stop_line.set(true, 0); },
       [](Bench& b) { b.stop_line.set(false, 0); }, 1},
      {"emergency stop pulse", AlarmCause::kEmergencyStop, 0xFF01, 0, [](Bench& b) { b.stop_line.pulse(0); },
       [](Bench&) {}, 1},
      {"saturated three in a row", AlarmCause::kSensorSaturated, 0xFF02, 1,
       [](Bench& b) { b.spoil.code[0][3] = 16000000; }, [](Bench& b) { b.spoil.code[0][3] = 0; }, 3},
      {"saturated negative", AlarmCause::kSensorSaturated, 0xFF02, 1, [](Bench& b) { b.spoil.code[0][2] = -16000000; },
       [](Bench& b) { b.spoil.code[0][2] = 0; }, 3},
      {"three samples missing", AlarmCause::kSensorLost, 0xFF03, 2, [](Bench& b) { b.sequence += 3; }, [](Bench&) {},
       1},
      {"silent sensors", AlarmCause::kSensorLost, 0xFF03, 2, silent,
       [](Bench& b) { b.source.fail(hal::SampleFailure::kNone); }, 11},
      {"source fault", AlarmCause::kSensorFault, 0x5000, 2, [](Bench& b) { b.source.fail(hal::SampleFailure::kFault); },
       [](Bench& b) { b.source.fail(hal::SampleFailure::kNone); }, 1},
      {"source ends while driving", AlarmCause::kSensorFault, 0x5000, 2,
       [](Bench& b) { b.source.fail(hal::SampleFailure::kEnded); },
       [](Bench& b) { b.source.fail(hal::SampleFailure::kNone); }, 1},
      {"displacement beyond its limit", AlarmCause::kResponseLimit, 0xFF05, 4,
       [](Bench& b) { b.spoil.code[0][1] = 5000000; }, [](Bench& b) { b.spoil.code[0][1] = 0; }, 1},
      {"controller run late", AlarmCause::kStepLate, 0x6100, 5,
       [](Bench& b) { b.clock.advance_ns(60 * bench::kMillisecond_ns); }, [](Bench&) {}, 1},
      {"drive refused", AlarmCause::kDriveNotTaken, 0xFF06, 12, [](Bench& b) { b.drive.refuse(true); },
       [](Bench& b) { b.drive.refuse(false); }, 1},
  };
}

firmware::ControllerConfiguration limited() {
  auto configuration = bench::driving();
  configuration.limits.response_limit_code[0][1] = 4000000;  // 40 mm
  return configuration;
}

TEST(Faults, EachStopsTheDriveInTimeAndLatches) {
  for (ControllerMode mode : {ControllerMode::kRamp, ControllerMode::kSettle, ControllerMode::kIntegrate}) {
    for (const Case& each : cases()) {
      SCOPED_TRACE(each.name + " in mode " + std::to_string(static_cast<int>(mode)));
      Bench bench(limited());
      bench.drive_into(mode);
      ASSERT_TRUE(bench.relay.active());
      const size_t windows = bench.can.count(0x391);
      each.hurt(bench);
      bench.run_samples(each.samples_to_trip - 1);
      EXPECT_TRUE(bench.relay.active());  // not a sample too early
      bench.run_sample();
      EXPECT_FALSE(bench.relay.active());
      EXPECT_EQ(bench.controller->latched_alarm().cause, each.cause);
      EXPECT_EQ(bench.controller->mode(),
                each.cause == AlarmCause::kEmergencyStop ? ControllerMode::kEmergencyStop : ControllerMode::kFault);
      EXPECT_FALSE(bench.lamp.active());
      ASSERT_NE(bench.can.last(kEmergencyId), nullptr);
      EXPECT_EQ(emergency_code(*bench.can.last(kEmergencyId)), each.code);
      EXPECT_NE(bench.can.last(kEmergencyId)->data[2], 0);  // error register
      EXPECT_TRUE(faults_of(*bench.can.last(kStatusId)) >> each.status_bit & 1);
      // Latched: healed, it stays; started, it refuses.
      each.heal(bench);
      bench.run_samples(200);
      EXPECT_TRUE(bench.dead());
      EXPECT_FALSE(bench.controller->start());
      bench.run_samples(5);
      EXPECT_TRUE(bench.dead());
      EXPECT_EQ(bench.can.last(kHeartbeatId)->data[0], 4);  // STOPPED
      EXPECT_EQ(bench.can.count(0x391), windows);
      // Reset and start again.
      bench.network_command(129, 0);
      bench.run_samples(200);
      EXPECT_EQ(bench.controller->mode(), ControllerMode::kIdle);
      EXPECT_EQ(emergency_code(*bench.can.last(kEmergencyId)), 0);
      EXPECT_TRUE(bench.lamp.active());
      EXPECT_TRUE(bench.controller->start());
      bench.run_samples(20);
      EXPECT_TRUE(bench.relay.active());
    }
  }
}

// A 24-bit converter with offset binary: its lower half is no saturation, its lower rail is.
TEST(Faults, OffsetBinaryIsSaturatedAtBothRailsAndNowhereElse) {
  constexpr int32_t kMiddle = 8388608;
  auto configuration = bench::driving();
  firmware::ChannelConfiguration& channel = configuration.core.channels[0][1];
  channel.offset_code = kMiddle;
  channel.lowest_code = 0;
  channel.highest_code = 16777215;
  for (const int32_t rail : {-kMiddle, kMiddle - 1}) {
    Bench bench(configuration);
    bench.spoil.code[0][1] = kMiddle;
    bench.drive_into(ControllerMode::kIntegrate);
    bench.run_samples(500);
    EXPECT_EQ(bench.controller->counters().saturated_samples, 0u);
    for (int i = 0; i < 3; ++i) {
      EXPECT_FALSE(bench.controller->latched_alarm());
      bench.spoil.code[0][1] = 0;
      firmware::RawSample at_rail = bench.rig.sample(bench.sequence++);
      at_rail.code[0][1] = rail + kMiddle;
      bench.clock.advance_ns(bench::kMillisecond_ns);
      bench.source.offer(at_rail);
      bench.step();
    }
    EXPECT_EQ(bench.controller->latched_alarm().cause, AlarmCause::kSensorSaturated);
    EXPECT_TRUE(bench.dead());
  }
}

// Samples that keep coming, each later than the one before: the newest is what counts, by its own time.
TEST(Faults, SamplesThatComeLateAreLost) {
  Bench bench(bench::driving());
  bench.drive_into(ControllerMode::kIntegrate);
  for (int late_ms = 0; late_ms <= 9; ++late_ms) {  // and one more until the next step looks at the time
    bench.late_ns = static_cast<uint64_t>(late_ms) * bench::kMillisecond_ns;
    bench.run_samples(5);
    EXPECT_FALSE(bench.controller->latched_alarm()) << late_ms;
  }
  bench.late_ns = 11 * bench::kMillisecond_ns;
  bench.run_sample();
  EXPECT_TRUE(bench.dead());
  EXPECT_EQ(bench.controller->latched_alarm().cause, AlarmCause::kSensorLost);
  EXPECT_EQ(bench.controller->latched_alarm().detail, 11u);
}

TEST(Faults, UndeliveredSafeStateIsTriedAgainAndStarvesTheWatchdog) {
  Bench bench(bench::driving());
  bench.drive_into(ControllerMode::kIntegrate);
  bench.relay.refuse(true);
  bench.stop_line.pulse(0);
  bench.run_sample();
  EXPECT_EQ(bench.drive.drive_q31(), 0);
  EXPECT_TRUE(bench.relay.active());  // it would not open
  const uint64_t feeds = bench.watchdog.feeds();
  bench.run_samples(10);
  EXPECT_EQ(bench.watchdog.feeds(), feeds);
  EXPECT_FALSE(bench.controller->reset());
  bench.relay.refuse(false);
  bench.run_sample();
  EXPECT_TRUE(bench.dead());
  bench.run_samples(10);
  EXPECT_EQ(bench.watchdog.feeds(), feeds + 11);
  EXPECT_TRUE(bench.controller->reset());
}

TEST(Faults, WatchdogIsFedInEveryHealthyStep) {
  Bench bench(bench::driving());
  bench.step();
  bench.controller->start();
  bench.run_samples(500);
  EXPECT_EQ(bench.watchdog.feeds(), 501u);
}

TEST(Faults, RelayThatDoesNotCloseIsAFault) {
  Bench bench(bench::driving());
  bench.step();
  bench.relay.refuse(true);
  EXPECT_FALSE(bench.controller->start());
  bench.relay.refuse(false);
  bench.run_samples(3);
  EXPECT_EQ(bench.controller->latched_alarm().cause, AlarmCause::kRelayNotTaken);
  EXPECT_TRUE(bench.dead());
}

TEST(Faults, BadProgrammeIsRefusedAtBootAndCannotBeReset) {
  auto configuration = bench::driving();
  configuration.programme.levels[1].amplitude.raw = INT32_MAX;  // over the limit of one half
  configuration.programme.start_at_boot = true;
  Bench bench(configuration);
  bench.run_samples(20);
  EXPECT_TRUE(bench.dead());
  EXPECT_EQ(bench.controller->latched_alarm().cause, AlarmCause::kConfiguration);
  EXPECT_EQ(emergency_code(*bench.can.last(kEmergencyId)), 0x6300);
  EXPECT_FALSE(bench.controller->reset());
}

// One effect more than the core has columns for: refused at boot, and nothing is measured into columns that are not there.
TEST(Faults, ARigThatHasNoRoomMeasuresNothing) {
  auto configuration = bench::listening();
  firmware::CoreConfiguration& core = configuration.core;
  for (int effect = 0; effect <= firmware::kMaxEffectColumns; ++effect) {
    firmware::Term& term = core.terms[core.term_count++];
    term.kind = firmware::TermKind::kCubicDamping;
    term.value = firmware::Scaled::from_int(1);
  }
  Bench bench(configuration);
  bench.run_samples(2000);  // two windows
  EXPECT_FALSE(bench.controller->core().fits());
  EXPECT_EQ(bench.controller->latched_alarm().cause, AlarmCause::kConfiguration);
  EXPECT_EQ(bench.controller->core().health().samples, 0u);
  EXPECT_EQ(bench.can.count(0x391), 0u);
}

TEST(Faults, NothingStopsOnOneSaturatedSampleOrAShortGap) {
  Bench bench(bench::driving());
  bench.drive_into(ControllerMode::kIntegrate);
  for (int repeat = 0; repeat < 20; ++repeat) {
    bench.spoil.code[0][1] = 16000000;
    bench.run_samples(2);
    bench.spoil.code[0][1] = 0;
    bench.sequence += 2;
    bench.run_samples(2);
  }
  EXPECT_FALSE(bench.controller->latched_alarm());
  EXPECT_TRUE(bench.relay.active());
  EXPECT_EQ(bench.controller->counters().missed_samples, 40u);
  EXPECT_EQ(bench.controller->counters().saturated_samples, 40u);
  EXPECT_EQ(emergency_code(*bench.can.last(kEmergencyId)), 0xFF04);
}

// Ten samples with all four channels at a rail are ten, and so the health frame has it (saturated_samples: bytes 5 and 6).
TEST(Faults, ASampleIsSaturatedOnce) {
  Bench bench(bench::listening());
  bench.run_samples(100);
  for (int32_t& code : bench.spoil.code[0]) code = 16777214;
  bench.run_samples(10);
  for (int32_t& code : bench.spoil.code[0]) code = 0;
  bench.run_samples(2000);
  EXPECT_EQ(bench.controller->counters().saturated_samples, 10u);
  const hal::CanFrame* health = bench.can.last(0x281);
  ASSERT_NE(health, nullptr);
  EXPECT_EQ(health->data[5] | health->data[6] << 8, 10);
}

TEST(Faults, ListeningGoesOnThroughWhatWouldStopADrive) {
  Bench bench(bench::listening());
  bench.run_samples(100);
  bench.spoil.code[0][1] = 16000000;
  bench.run_samples(10);
  bench.spoil.code[0][1] = 0;
  bench.sequence += 100;
  bench.run_samples(10);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kIntegrate);
  EXPECT_EQ(bench.controller->counters().missed_samples, 100u);
}

// One read that fails is a gap: of 1500 and 5000 samples 6 windows of 1000 are told. A source that fails for a second is gone.
TEST(Faults, ListeningGoesOnThroughAReadThatFails) {
  Bench bench(bench::listening());
  bench.run_samples(1500);
  bench.source.fail(hal::SampleFailure::kFault);
  bench.step();
  bench.source.fail(hal::SampleFailure::kNone);
  EXPECT_EQ(emergency_code(*bench.can.last(kEmergencyId)), 0x5000);
  bench.sequence += 3;  // what was not read
  bench.run_samples(5000);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kIntegrate);
  EXPECT_EQ(bench.can.count(0x391), 6u);
  EXPECT_EQ(bench.controller->core().health().missed_samples, 3u);
  bench.source.fail(hal::SampleFailure::kFault);
  bench.run_idle(1000);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kIntegrate);
  bench.run_idle(1);  // 1 s after the first that failed
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kDone);
  EXPECT_EQ(bench.can.count(0x391), 7u);
}

TEST(Faults, EmergencyFramesKeepTheirInhibitTime) {
  Bench bench(bench::listening());
  bench.run_samples(10);
  const uint64_t begin = bench.clock.now_ns();
  for (int i = 0; i < 1000; ++i) {  // a gap before every sample
    ++bench.sequence;
    bench.run_sample();
  }
  int told = 0;
  uint64_t last = 0;
  for (const hal::CanFrame& frame : bench.can.sent()) {
    if (frame.id != kEmergencyId || frame.time_ns <= begin) continue;
    EXPECT_GE(frame.time_ns - last, told > 0 ? 100 * bench::kMillisecond_ns : 0);
    ++told;
    last = frame.time_ns;
  }
  EXPECT_EQ(told, 10);  // 1 s of it, 100 ms apart
}

TEST(Faults, LevelThatDoesNotSettleIsTold) {
  auto configuration = bench::driving();
  configuration.programme.levels[0].settle_limit_samples = 120;  // four blocks of 50 cannot be complete
  Bench bench(configuration);
  bench.drive_into(ControllerMode::kIntegrate);
  ASSERT_NE(bench.can.last(kEmergencyId), nullptr);
  EXPECT_EQ(emergency_code(*bench.can.last(kEmergencyId)), 0xFF07);
  EXPECT_TRUE(bench.controller->excitation().unsettled());
  EXPECT_TRUE(bench.relay.active());
}

}  // namespace

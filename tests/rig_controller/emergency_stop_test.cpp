// No press of the emergency stop is lost, wherever between two reads of the line it begins and ends, whichever of level
// and edge shows first, in every mode and together with every command. What a look has seen has stopped the drive by
// the end of the next step; what lasts or leaves an edge has been seen by then.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/rig_controller/bench.hpp"

namespace {

using bench::Bench;
using firmware::AlarmCause;
using firmware::ControllerMode;
using Shows = hal::FakeInput::Shows;

constexpr uint8_t kStart = 1, kStop = 2, kReset = 129;
constexpr uint64_t kNever = UINT64_MAX;

// What the controller is doing, and what arrives in the very step in which the line is pressed.
struct Situation {
  std::string name;
  firmware::ControllerConfiguration configuration;
  std::function<void(Bench&)> reach;
  std::function<void(Bench&)> arrives = [](Bench&) {};
};

firmware::ControllerConfiguration quick() {
  auto made = bench::driving();
  made.programme.level_count = 1;
  made.programme.levels[0].ramp_samples = 20;
  made.programme.levels[0].settle_limit_samples = 60;
  made.programme.levels[0].measure_samples = 200;
  return made;
}

firmware::ControllerConfiguration free_decay() {
  auto made = quick();
  made.programme.levels[0].kind = firmware::ExcitationKind::kFreeDecay;
  made.programme.levels[0].phase_step = 0;
  return made;
}

firmware::ControllerConfiguration at_boot() {
  auto made = quick();
  made.programme.start_at_boot = true;
  return made;
}

firmware::ControllerConfiguration on_command() {
  auto made = bench::listening();
  made.node.listen_on_command = true;
  return made;
}

std::function<void(Bench&)> command(uint8_t code) {
  return [code](Bench& bench) { bench.network_command(code, 0); };
}

void boot(Bench& bench) { bench.run_samples(2); }

std::function<void(Bench&)> drive_into(ControllerMode mode) {
  return [mode](Bench& bench) {
    boot(bench);
    EXPECT_TRUE(bench.controller->start());
    EXPECT_TRUE(bench.run_until(mode));
  };
}

void fault(Bench& bench) {
  drive_into(ControllerMode::kSettle)(bench);
  bench.sequence += 5;
  bench.run_sample();
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kFault);
}

void stopped_and_released(Bench& bench) {
  drive_into(ControllerMode::kSettle)(bench);
  bench.stop_line.set(true, 0);
  bench.run_sample();
  bench.stop_line.set(false, 0);
  bench.run_sample();
}

std::vector<Situation> situations() {
  const auto nothing = [](Bench&) {};
  return {
      {"first step", quick(), nothing},
      {"first step, starts by itself", at_boot(), nothing},
      {"idle", quick(), boot},
      {"idle, start arrives", quick(), boot, command(kStart)},
      {"idle, start is called", quick(), boot, [](Bench& bench) { bench.controller->start(); }},
      {"idle, reset arrives", quick(), boot, command(kReset)},
      {"ramp", quick(), drive_into(ControllerMode::kRamp)},
      {"settle", quick(), drive_into(ControllerMode::kSettle)},
      {"integrate", quick(), drive_into(ControllerMode::kIntegrate)},
      {"integrate, stop arrives", quick(), drive_into(ControllerMode::kIntegrate), command(kStop)},
      {"integrate, start arrives", quick(), drive_into(ControllerMode::kIntegrate), command(kStart)},
      {"free decay", free_decay(), drive_into(ControllerMode::kFreeDecay)},
      {"done", quick(), drive_into(ControllerMode::kDone)},
      {"done, start arrives", quick(), drive_into(ControllerMode::kDone), command(kStart)},
      {"fault", quick(), fault},
      {"fault, reset arrives", quick(), fault, command(kReset)},
      {"fault, reset and start arrive", quick(), fault,
       [](Bench& bench) {
         bench.network_command(kReset, 0);
         bench.network_command(kStart, 0);
       }},
      {"stopped, reset arrives", quick(), stopped_and_released, command(kReset)},
      {"stopped, reset and start arrive", quick(), stopped_and_released,
       [](Bench& bench) {
         bench.network_command(kReset, 0);
         bench.network_command(kStart, 0);
       }},
      {"listening, idle", on_command(), boot},
      {"listening, start arrives", on_command(), boot, command(kStart)},
      {"listening, integrate", bench::listening(), boot},
      {"listening, stop arrives", bench::listening(), boot, command(kStop)},
  };
}

// When level and edge of a press and its release begin to show, as numbers of reads after the step's first.
struct Press {
  uint64_t level_on = kNever, level_off = kNever, edge_on = kNever, edge_off = kNever;

  bool lasts_or_leaves_an_edge() const {
    return edge_on != kNever || edge_off != kNever || (level_on != kNever && level_off == kNever);
  }
};

// Pressed before read `on`, released before read `off`; the edges show up to `reads` reads earlier or later than the
// level, or one of level, rising and falling edge does not show at all.
std::vector<Press> presses(uint64_t reads) {
  std::vector<Press> made;
  for (uint64_t on = 0; on <= reads; ++on) {
    std::vector<uint64_t> ends{kNever};
    for (uint64_t off = on; off <= reads; ++off) ends.push_back(off);
    for (uint64_t off : ends) {
      if (off != on) made.push_back({on, off, kNever, kNever});  // a line that tells of no edges
      made.push_back({kNever, kNever, on, off});                 // too short for a level
      made.push_back({kNever, kNever, kNever, on});              // told as a release alone
      for (uint64_t edge = 0; edge <= reads; ++edge) {
        made.push_back({on, off, edge, off == kNever ? kNever : std::max(off, edge)});
        made.push_back({on, off, edge, kNever});
      }
    }
  }
  return made;
}

void script(const Press& press, hal::FakeInput& line) {
  const uint64_t first = line.reads();
  const auto at = [&](uint64_t read, Shows what, bool active) {
    if (read != kNever) line.at_read(first + read, what, active);
  };
  at(press.level_on, Shows::kLevel, true);
  at(press.level_off, Shows::kLevel, false);
  at(press.edge_on, Shows::kEdge, true);
  at(press.edge_off, Shows::kEdge, false);
}

uint64_t reads_of_a_step(const Situation& situation) {
  Bench bench(situation.configuration);
  situation.reach(bench);
  const uint64_t before = bench.stop_line.reads();
  situation.arrives(bench);
  bench.run_sample();
  return bench.stop_line.reads() - before;
}

// Whether the press did what it must; counts it in `seen` where the controller had a chance to see it.
void expect_stopped(const Situation& situation, const Press& press, int& seen) {
  Bench bench(situation.configuration);
  situation.reach(bench);
  hal::FakeInput& line = bench.stop_line;
  line.forget_what_was_seen();
  script(press, line);
  situation.arrives(bench);
  bench.run_sample();
  const bool at_once = line.seen();
  if (at_once) {
    EXPECT_EQ(bench.controller->mode(), ControllerMode::kEmergencyStop);
    EXPECT_TRUE(bench.dead());
  }
  bench.run_sample();
  if (press.lasts_or_leaves_an_edge()) {
    EXPECT_TRUE(line.seen());
  }
  if (!line.seen()) return;
  ++seen;
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kEmergencyStop);
  EXPECT_TRUE(bench.dead());
  bench.run_samples(3);
  EXPECT_FALSE(bench.controller->start());
  EXPECT_EQ(bench.controller->latched_alarm().cause, AlarmCause::kEmergencyStop);
  EXPECT_TRUE(bench.dead());
}

TEST(EmergencyStop, NoPressIsLostAtAnyReadInAnyModeInAnyOrder) {
  int tried = 0, seen = 0;
  for (const Situation& situation : situations()) {
    const uint64_t reads = reads_of_a_step(situation);
    ASSERT_GE(reads, 2u) << situation.name;
    for (const Press& press : presses(reads)) {
      SCOPED_TRACE(testing::Message() << situation.name << ": level " << press.level_on << " to " << press.level_off
                                      << ", edges " << press.edge_on << " and " << press.edge_off);
      expect_stopped(situation, press, seen);
      ++tried;
      if (HasFailure()) return;  // one is enough to read
    }
  }
  std::printf("%d presses in %zu situations, %d of them seen, none lost\n", tried, situations().size(), seen);
  EXPECT_GT(seen, 1000);
}

// What a chattering contact does: more edges than are looked at in a step do not hold the step up and are a press.
TEST(EmergencyStop, AChatteringLineIsAPressAndHoldsNothingUp) {
  Bench bench(quick());
  drive_into(ControllerMode::kIntegrate)(bench);
  for (int i = 0; i < 10000; ++i) bench.stop_line.pulse(0);
  const uint64_t before = bench.stop_line.reads();
  bench.run_sample();
  EXPECT_TRUE(bench.dead());
  EXPECT_LE(bench.stop_line.reads() - before, 64u);
  EXPECT_FALSE(bench.controller->reset());
}

TEST(EmergencyStop, APressHeldForSecondsIsToldOnceAndEndsWithAReset) {
  Bench bench(quick());
  drive_into(ControllerMode::kIntegrate)(bench);
  const size_t told = bench.can.count(0x081);
  bench.stop_line.set(true, 0);
  bench.run_samples(2000);
  EXPECT_TRUE(bench.dead());
  EXPECT_EQ(bench.can.count(0x081), told + 1);
  EXPECT_EQ(bench.controller->trips(), 1u);
  EXPECT_FALSE(bench.controller->reset());
  bench.stop_line.set(false, 0);
  bench.run_sample();
  EXPECT_FALSE(bench.controller->reset());  // it was pressed until this step
  bench.run_sample();
  EXPECT_TRUE(bench.dead());
  EXPECT_TRUE(bench.controller->reset());
  EXPECT_TRUE(bench.controller->start());
  bench.run_samples(5);
  EXPECT_TRUE(bench.relay.active());
}

}  // namespace

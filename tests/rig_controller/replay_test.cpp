// A replayed record: levels marked by its owner, the same estimates as from the core by itself.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hal/rig_file/scaled_double.hpp"
#include "host_sim/virtual_rig/replay_board.hpp"
#include "tests/rig_controller/bench.hpp"

namespace {

using firmware::ControllerMode;

struct Recorder {
  std::vector<hal::CanFrame> frames;
  host_sim::ReplayBoard::Take take() {
    return [this](const hal::CanFrame& frame) { frames.push_back(frame); };
  }
  size_t count(uint32_t id) const {
    size_t found = 0;
    for (const hal::CanFrame& frame : frames) found += frame.id == id ? 1 : 0;
    return found;
  }
};

// Two levels of the bench's rig under 20 Hz, 100 samples to settle before each.
std::vector<firmware::RawSample> level(double force_N, uint32_t& sequence) {
  bench::OneDofRig rig;
  std::vector<firmware::RawSample> samples;
  for (int i = 0; i < 2000; ++i) {
    rig.advance(force_N * std::sin(2.0 * M_PI * 20.0 * i / 1000.0), 1e-3);
    samples.push_back(rig.sample(sequence++));
  }
  return samples;
}

TEST(Replay, SameEstimatesAsTheCoreAlone) {
  const auto configuration = bench::listening();
  Recorder bus;
  host_sim::ReplayBoard board(configuration, bus.take());
  auto core = std::make_unique<firmware::EstimatorCore>(configuration.core);
  uint32_t sequence = 0;
  int windows = 0;
  board.run_at(0);
  for (double force_N : {20.0, 50.0}) {
    board.begin_level();
    core->begin_level();
    EXPECT_EQ(board.controller().mode(), ControllerMode::kIntegrate);
    for (const firmware::RawSample& sample : level(force_N, sequence)) {
      windows += board.push(sample, (sample.sequence + 1) * bench::kMillisecond_ns) ? 1 : 0;
      core->push(sample);
    }
    board.end_level();
    core->end_level();
    EXPECT_EQ(board.controller().mode(), ControllerMode::kIdle);
  }
  board.finish((sequence + 1) * bench::kMillisecond_ns);
  EXPECT_EQ(board.controller().mode(), ControllerMode::kDone);
  const firmware::Estimates& alone = core->solve();
  ASSERT_NE(board.controller().estimates(), nullptr);
  const firmware::Estimates& replayed = *board.controller().estimates();
  EXPECT_EQ(windows, 4);  // two of 1000 samples in each level; the one at its end has no samples of its own
  EXPECT_EQ(replayed.parameters[0].value.mantissa, alone.parameters[0].value.mantissa);
  EXPECT_EQ(replayed.parameters[0].value.exponent, alone.parameters[0].value.exponent);
  EXPECT_EQ(replayed.rows, alone.rows);
  EXPECT_EQ(board.core().table().level_count, 2);
  EXPECT_GE(bus.count(0x701), 40u);
  EXPECT_EQ(bus.count(0x410), 6u);
  for (size_t i = 1; i < bus.frames.size(); ++i) EXPECT_LE(bus.frames[i - 1].time_ns, bus.frames[i].time_ns);
}

// The bench's force stands from sample to sample and is read before it jumps, the acceleration likewise: m a = F - k x - c v holds
// exactly, though against the velocity the acceleration comes late. Taken for late it would make 22.7 of c = 20.
TEST(Replay, AForceThatIsSampledBeforeItsJumpIsNoLateAcceleration) {
  firmware::CoreConfiguration configuration = bench::listening().core;
  auto core = std::make_unique<firmware::EstimatorCore>(configuration);
  uint32_t sequence = 0;
  core->begin_level();
  for (const firmware::RawSample& sample : level(20.0, sequence)) {
    core->push(sample);
    if (sample.sequence % 500 != 499) continue;
    const firmware::Estimates& estimates = core->solve();
    EXPECT_FALSE(estimates.warrant.corrected);
    EXPECT_NEAR(rig_file::to_double(estimates.parameters[0].value), 20.0, 0.01);
  }
  EXPECT_TRUE(core->estimates().acceleration_skew[0].significant);
}

TEST(Replay, SamplesBetweenLevelsAreLeftOut) {
  Recorder bus;
  host_sim::ReplayBoard board(bench::listening(), bus.take());
  uint32_t sequence = 0;
  board.run_at(0);
  for (const firmware::RawSample& sample : level(20.0, sequence))
    board.push(sample, (sample.sequence + 1) * bench::kMillisecond_ns);
  EXPECT_EQ(board.core().health().samples, 0u);
  EXPECT_EQ(bus.count(0x410), 0u);
}

TEST(Replay, StartAndStopOverTheBus) {
  auto configuration = bench::listening();
  configuration.node.listen_on_command = true;
  bench::Bench bench(configuration);
  bench.run_samples(100);
  EXPECT_EQ(bench.controller->mode(), ControllerMode::kIdle);
  for (int round = 1; round <= 2; ++round) {
    bench.network_command(1, 0);
    bench.run_samples(500);
    EXPECT_EQ(bench.controller->mode(), ControllerMode::kIntegrate);
    bench.network_command(2, 0);
    bench.run_samples(10);
    EXPECT_EQ(bench.controller->mode(), ControllerMode::kIdle);
    EXPECT_EQ(bench.controller->core().table().level_count, round);
    EXPECT_EQ(bench.can.count(0x391), static_cast<size_t>(round));
  }
  EXPECT_FALSE(bench.relay.active());
  bench.network_command(129, 0);
  bench.run_samples(2);
  EXPECT_EQ(bench.controller->core().table().level_count, 0);
}

}  // namespace

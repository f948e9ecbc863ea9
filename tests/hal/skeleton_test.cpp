// The start for a new board, as it stands: safe whatever is asked of it. And the parts of it that are complete.
#include <gtest/gtest.h>

#include <thread>

#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/fake/fake_devices.hpp"
#include "hal/skeleton/board.hpp"

namespace {

// A rig with one DOF that would be driven from boot on.
std::unique_ptr<firmware::ControllerConfiguration> eager() {
  auto configuration = std::make_unique<firmware::ControllerConfiguration>();
  configuration->core.dof_count = 1;
  configuration->programme.level_count = 1;
  configuration->programme.start_at_boot = true;
  firmware::ExcitationLevel& level = configuration->programme.levels[0];
  level.amplitude = firmware::Drive::from_raw(1 << 20);
  level.phase_step = 1 << 24;
  level.ramp_samples = level.measure_samples = 100;
  return configuration;
}

// Only the watchdog is a fake here, to see whether it is fed.
TEST(Skeleton, AsItStandsItNeitherStartsNorSaysThatItIsSafe) {
  skeleton::Clock clock;
  skeleton::Samples samples;
  skeleton::Can can;
  skeleton::Drive drive;
  skeleton::Line relay(1), lamp(2);
  skeleton::StopLine stop_line;
  hal::FakeWatchdog dog;
  skeleton::Store store;
  skeleton::LoopWorker worker;
  const auto configuration = eager();
  const auto controller = std::make_unique<firmware::RigController>(
      *configuration,
      firmware::Ports{clock, samples, can, drive, relay, lamp, stop_line, nullptr, dog, store, &worker, nullptr});
  for (int i = 0; i < 1000; ++i) {
    controller->step();
    EXPECT_FALSE(controller->start());
    EXPECT_FALSE(controller->reset());
    worker.run();
  }
  EXPECT_EQ(controller->mode(), firmware::ControllerMode::kEmergencyStop);
  EXPECT_EQ(dog.feeds(), 0u);  // outputs that do not deliver: the board's watchdog is its last resort
}

TEST(Skeleton, OutputsAnswerNoAndTheStopReadsPressed) {
  EXPECT_TRUE(skeleton::StopLine().active());
  EXPECT_FALSE(skeleton::Drive().write(0));
  EXPECT_FALSE(skeleton::Line(1).set(false));
  EXPECT_FALSE(skeleton::Line(2).set(true));
  const uint8_t byte = 1;
  EXPECT_FALSE(skeleton::Store().save(&byte, 1));
  EXPECT_NE(skeleton::Can().send({}), hal::CanResult::kDone);
}

TEST(Skeleton, TheRingKeepsOrderAndCountsWhatItDrops) {
  skeleton::Samples samples;
  firmware::RawSample sample;
  for (uint32_t i = 0; i < 70; ++i) {
    sample.sequence = i;
    samples.sample_complete(sample);
  }
  EXPECT_EQ(samples.overflows(), 6u);  // 64 places
  for (uint32_t i = 0; i < 64; ++i) {
    ASSERT_EQ(samples.read(sample), hal::SampleResult::kSample);
    EXPECT_EQ(sample.sequence, i);
  }
  EXPECT_EQ(samples.read(sample), hal::SampleResult::kNone);
}

// The interrupt is another thread here: no sample comes before its contents, on processors that reorder too.
TEST(Skeleton, ASampleIsWholeWhenItIsSeen) {
  constexpr uint32_t kSamples = 200000;
  skeleton::Samples samples;
  std::atomic<bool> ended{false};
  std::thread interrupt([&] {
    firmware::RawSample sample;
    for (sample.sequence = 1; sample.sequence <= kSamples; ++sample.sequence) {
      for (auto& node : sample.code)
        for (int32_t& code : node) code = static_cast<int32_t>(sample.sequence);
      samples.sample_complete(sample);
    }
    ended = true;
  });
  uint32_t last = 0, torn = 0;
  firmware::RawSample sample;
  for (;;) {
    const bool over = ended;
    if (samples.read(sample) != hal::SampleResult::kSample) {
      if (over) break;
      continue;
    }
    for (const auto& node : sample.code)
      for (const int32_t code : node) torn += code != static_cast<int32_t>(sample.sequence);
    torn += sample.sequence <= last;
    last = sample.sequence;
  }
  interrupt.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_GT(last, 0u);
}

TEST(Skeleton, TheWorkerRunsWhatIsAskedInTheMainLoop) {
  skeleton::LoopWorker worker;
  int runs = 0;
  worker.run();
  EXPECT_TRUE(worker.done());
  worker.start([](void* count) { ++*static_cast<int*>(count); }, &runs);
  EXPECT_FALSE(worker.done());
  EXPECT_EQ(runs, 0);
  worker.run();
  EXPECT_TRUE(worker.done());
  worker.run();
  EXPECT_EQ(runs, 1);
}

}  // namespace

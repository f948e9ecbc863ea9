// One hour of a rig at 1 kHz, in simulated time: no sample missed, no allocation after the start (any is fatal, see
// allocation_guard.cpp), so the memory is flat by proof.
#include <gtest/gtest.h>

#include <memory>

#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/fake/fake_can_bus.hpp"
#include "hal/fake/fake_configuration_store.hpp"
#include "hal/fake/fake_devices.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/toml/rig_reader.hpp"

extern "C" void allocation_guard_begin();
extern "C" void allocation_guard_end();

namespace {

constexpr uint64_t kPeriod_ns = 1000000;

// A sample for every step of the clock: integer triangles of different lengths, so that no two channels are alike.
class TriangleSource final : public hal::SampleSource {
 public:
  explicit TriangleSource(hal::ManualClock& clock) : clock_(clock) {}
  hal::SampleResult read(firmware::RawSample& sample) override {
    const auto due = static_cast<uint32_t>(clock_.now_ns() / kPeriod_ns);
    if (due <= sequence_) return hal::SampleResult::kNone;
    sequence_ = due;
    sample = firmware::RawSample();
    sample.sequence = sequence_;
    sample.time_ns = clock_.now_ns();
    for (int dof = 0; dof < 3; ++dof)
      for (int quantity = 0; quantity < 4; ++quantity)
        sample.code[dof][quantity] = triangle(sequence_, 40 + 14 * quantity + 6 * dof);
    return hal::SampleResult::kSample;
  }

 private:
  static int32_t triangle(uint32_t sequence, int32_t period) {
    const auto place = static_cast<int32_t>(sequence % static_cast<uint32_t>(period));
    return 100000 * (place < period / 2 ? place : period - place) / period - 25000;
  }
  hal::ManualClock& clock_;
  uint32_t sequence_ = 0;
};

constexpr char kRig[] = R"(schema = "rig/1"
dof = [{ mass_kg = 1.5 }, { mass_kg = 1.3 }, { mass_kg = 2.0 }]
link = [
  { between = [1, 0], stiffness_N_m = 1e4, viscous_N_s_m = "estimate" },
  { between = [1, 2], stiffness_N_m = 1e4, viscous_N_s_m = "estimate" },
  { between = [2, 3], stiffness_N_m = 1e4, viscous_N_s_m = "estimate" },
  { between = [3, 0], stiffness_N_m = 1e4, viscous_N_s_m = "estimate", coulomb_N = "estimate" },
]
)";

std::unique_ptr<firmware::ControllerConfiguration> configuration() {
  std::vector<rig_file::ChannelCalibration> channels;
  for (int dof = 1; dof <= 3; ++dof)
    for (int quantity = 0; quantity < 4; ++quantity)
      channels.push_back({static_cast<firmware::Quantity>(quantity), dof, 1e-5});
  auto result = std::make_unique<firmware::ControllerConfiguration>();
  result->core = rig_file::compile_rig(rig_file::parse_rig(kRig, "endurance"), 1e-3, channels);
  return result;
}

TEST(Endurance, OneHourWithoutAnAllocationOrAMissedSample) {
  constexpr uint32_t kSamples = 3600 * 1000;
  const auto settings = configuration();
  hal::ManualClock clock;
  hal::FakeCanBus bus(clock);
  bus.keep_frames(false);
  TriangleSource samples(clock);
  hal::FakeDrive drive;
  hal::FakeOutput relay, lamp;
  hal::FakeInput stop_line;
  hal::FakeWatchdog watchdog;
  hal::FakeConfigurationStore store;
  const auto controller = std::make_unique<firmware::RigController>(
      *settings, firmware::Ports{clock, samples, bus, drive, relay, lamp, stop_line, nullptr, watchdog, store});
  allocation_guard_begin();
  for (uint32_t i = 0; i < kSamples; ++i) {
    clock.advance_ns(kPeriod_ns);
    controller->step();
  }
  allocation_guard_end();
  EXPECT_EQ(controller->core().health().samples, kSamples);
  EXPECT_EQ(controller->core().health().missed_samples, 0u);
  EXPECT_EQ(controller->counters().missed_samples, 0u);
  EXPECT_EQ(watchdog.feeds(), kSamples);
  EXPECT_EQ(controller->transmit_queue().given_up(), 0u);
  EXPECT_FALSE(controller->latched_alarm());
  ASSERT_NE(controller->estimates(), nullptr);
  EXPECT_EQ(controller->estimates()->window_counter, 3600u);  // one window a second
  // Five estimates a window, ten heartbeats a second, and the rest.
  EXPECT_GT(bus.sent_count(), 3600u * (5 + 10));
}

// The guard is not asleep: an allocation under it ends the program.
TEST(EnduranceDeathTest, AnAllocationUnderTheGuardIsFatal) {
  EXPECT_DEATH(
      {
        allocation_guard_begin();
        ::operator delete(::operator new(16));
      },
      "ALLOCATION AFTER START");
}

}  // namespace

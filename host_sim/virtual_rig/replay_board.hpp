// A board made of fakes on which a RigController listens to samples that are already known: recordings, simulations.
// Whoever owns the samples marks the levels and sets the time, and is given every frame that the controller sends.
#pragma once
#include <functional>
#include <memory>

#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/fake/fake_configuration_store.hpp"
#include "hal/fake/fake_devices.hpp"
#include "hal/fake/fake_sample_source.hpp"

namespace host_sim {

class ReplayBoard {
 public:
  // configuration.programme must be empty; levels are marked by begin_level() and end_level() alone.
  // take: is called with each frame as it is sent, its time_ns set.
  using Take = std::function<void(const hal::CanFrame&)>;
  ReplayBoard(const firmware::ControllerConfiguration& configuration, Take take);

  // The controller runs at this time of its clock, without a sample; time never goes back.
  void run_at(uint64_t time_ns);
  void begin_level();
  // One sample at its time. Outside a level it is looked at by supervision only. True where it closed a window.
  bool push(const firmware::RawSample& sample, uint64_t time_ns);
  void end_level();
  // No more samples: the controller says that it is done.
  void finish(uint64_t time_ns);

  const firmware::RigController& controller() const { return *controller_; }
  const firmware::EstimatorCore& core() const { return controller_->core(); }

 private:
  class FrameBus final : public hal::CanBus {
   public:
    FrameBus(hal::ManualClock& clock, Take take) : clock_(clock), take_(std::move(take)) {}
    hal::CanResult send(const hal::CanFrame& frame) override;
    hal::CanResult receive(hal::CanFrame&) override { return hal::CanResult::kEmpty; }

   private:
    hal::ManualClock& clock_;
    Take take_;
  };
  static firmware::ControllerConfiguration commanded(firmware::ControllerConfiguration configuration);

  hal::ManualClock clock_;
  FrameBus bus_;
  hal::FakeSampleSource source_;
  hal::FakeDrive drive_;
  hal::FakeOutput relay_, lamp_;
  hal::FakeInput stop_line_;
  hal::FakeWatchdog watchdog_;
  hal::FakeConfigurationStore store_;
  std::unique_ptr<firmware::RigController> controller_;  // large: not for the stack
};

}  // namespace host_sim

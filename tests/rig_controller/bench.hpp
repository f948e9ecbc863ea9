// A controller on fake hardware with a one-DOF rig in front of it: m = 1 kg, k = 1e4 N/m, c = 20 N s/m, 1 kHz, driven
// at the mass; 200 N at full scale. Displacement 1e-8 m per code, velocity 1e-6 m/s per code, force 1e-4 N per code.
#pragma once
#include <memory>

#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/fake/fake_can_bus.hpp"
#include "hal/fake/fake_configuration_store.hpp"
#include "hal/fake/fake_devices.hpp"
#include "hal/fake/fake_sample_source.hpp"

namespace bench {

constexpr uint64_t kMillisecond_ns = 1000000;
constexpr double kFullScaleForce_N = 200.0;
constexpr uint32_t kEmergencyId = 0x081;  // of node 1

firmware::CoreConfiguration one_dof_core();
// Two levels of 20 Hz, 50 samples a cycle: ramp 100, settle at least 4 cycles, measure 1000 samples each.
firmware::ExcitationProgramme two_levels();
firmware::ControllerConfiguration driving();
firmware::ControllerConfiguration driving_at_boot();  // the same, which does not wait for START
firmware::ControllerConfiguration listening();

// The rig integrated in small steps, in double; shares nothing with the core.
class OneDofRig {
 public:
  void advance(double force_N, double time_s);
  firmware::RawSample sample(uint32_t sequence) const;

 private:
  double position_m_ = 0.0, velocity_m_s_ = 0.0, force_N_ = 0.0;
};

struct Bench {
  explicit Bench(const firmware::ControllerConfiguration& configuration);

  void step() { controller->step(); }
  // One sample period: the rig moves under the drive, a sample comes, the controller runs.
  void run_sample();
  void run_samples(int count) {
    for (int i = 0; i < count; ++i) run_sample();
  }
  // Time passes without samples, one step per millisecond.
  void run_idle(int milliseconds);
  // Runs until the mode is reached; false after `limit` samples.
  bool run_until(firmware::ControllerMode mode, int limit = 20000);
  // Started, and 20 samples into that mode.
  void drive_into(firmware::ControllerMode mode);
  // A restart of the program on the same hardware.
  void restart();
  bool dead() const { return drive.drive_q31() == 0 && !relay.active(); }

  void network_command(uint8_t command, uint8_t node);
  void sync();
  // An SDO exchange; returns the reply's data as one little-endian word and its command byte.
  struct Reply {
    bool came = false;
    uint8_t command = 0;
    uint32_t value = 0;
    uint8_t data[8] = {};
  };
  Reply sdo(uint8_t command, uint16_t index, uint8_t subindex, uint32_t value = 0);

  firmware::ControllerConfiguration configuration;
  hal::ManualClock clock;
  hal::FakeSampleSource source;
  hal::FakeCanBus can{clock};
  hal::FakeDrive drive;
  hal::FakeOutput relay, lamp;
  hal::FakeInput stop_line, sync_line;
  hal::FakeWatchdog watchdog;
  hal::FakeConfigurationStore store;
  OneDofRig rig;
  hal::Worker* worker = nullptr;        // from the next restart on
  hal::Worker* store_worker = nullptr;  // likewise
  uint32_t sequence = 0;
  uint64_t late_ns = 0;       // how old samples are when they come
  firmware::RawSample spoil;  // added to each sample's codes
  std::unique_ptr<firmware::RigController> controller;
};

}  // namespace bench

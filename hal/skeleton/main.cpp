// The whole program of a board: a configuration, the devices, step() in the interrupt of the sample timer, and the long
// calculations below it.
#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/skeleton/board.hpp"

namespace {

// The rig, its channels and the excitation programme as bytes, made on the PC from the board's TOML file:
//   rig_controller --bytes board.toml > hal/<your board>/configuration_bytes.inc
constexpr uint8_t kConfigurationBytes[] = {
#if __has_include("configuration_bytes.inc")
#include "configuration_bytes.inc"
#else
    0
#endif
};

firmware::RigController* running = nullptr;

// The interrupt of the sample timer, below that of the converters: the controller once per sample.
void sample_timer_interrupt() { running->step(); }

// Sets the timer to the sample rate and enables its interrupt.
void start_sample_timer(void (*)()) {}

// Nothing is known of the rig: no node number, no limits, no channels. The watchdog is not fed, so the board also comes
// back here after each reset; a lamp that never lights tells.
[[noreturn]] void stay_safe(hal::DriveOutput& drive, hal::DigitalOutput& relay) {
  for (;;) {
    relay.set(false);
    drive.write(0);
  }
}

}  // namespace

int main() {
  static skeleton::Clock clock;
  static skeleton::Samples samples;
  static skeleton::Can can;
  static skeleton::Drive drive;
  static skeleton::Line relay(1), lamp(2);
  static skeleton::StopLine stop_line;
  static skeleton::Dog dog;
  static skeleton::Store store;
  static skeleton::LoopWorker worker;
  static firmware::ControllerConfiguration configuration;
  if (!firmware::decode(kConfigurationBytes, sizeof kConfigurationBytes, configuration)) stay_safe(drive, relay);
  static firmware::RigController controller(
      configuration, {clock, samples, can, drive, relay, lamp, stop_line, nullptr, dog, store, &worker, nullptr});
  running = &controller;
  start_sample_timer(sample_timer_interrupt);
  for (;;) worker.run();
}

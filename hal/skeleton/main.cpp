// The whole program of a board: a configuration, the devices, and step() for ever.
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

firmware::ControllerConfiguration configuration() {
  firmware::ControllerConfiguration result;
  // Bytes that do not fit leave the configuration empty: the controller then has no channels and reports no estimates.
  static_cast<void>(!firmware::decode(kConfigurationBytes, sizeof kConfigurationBytes, result));
  return result;
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
  static firmware::RigController controller(configuration(),
                                            {clock, samples, can, drive, relay, lamp, stop_line, nullptr, dog, store});
  for (;;) controller.step();  // a board with an operating system waits for the next interrupt here
}

// What a board must send: the controller of a board file, fed with a recorded sensor log on this machine, in the log's
// time. usage: board_reference BOARD.toml SENSORS.log    writes a candump log After the log the network command "stop"
// closes the level, as the boards are told to.
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>

#include "firmware/rig_controller/bus/can_sample_source.hpp"
#include "firmware/rig_controller/rig_controller.hpp"
#include "hal/fake/fake_can_bus.hpp"
#include "hal/fake/fake_configuration_store.hpp"
#include "hal/fake/fake_devices.hpp"
#include "hal/linux/board/board_file.hpp"
#include "host_sim/can_log/log_reader.hpp"
#include "host_sim/can_log/log_writer.hpp"

namespace {

class Reference {
 public:
  explicit Reference(const board::BoardFile& file)
      : bus_(clock_),
        sensor_bus_(clock_),
        samples_(sensor_bus_, firmware::sensor_plan(file.controller.core, file.samples.wiring)),
        controller_(file.controller,
                    {clock_, samples_, bus_, drive_, relay_, lamp_, stop_line_, nullptr, watchdog_, store_}) {}

  void feed(const hal::CanFrame& frame) {
    clock_.set_ns(frame.time_ns);
    sensor_bus_.inject(frame);
    controller_.step();
  }
  void stop() {
    hal::CanFrame command;
    command.length = 2;
    command.data[0] = 2;
    bus_.inject(command);
    for (int i = 0; i < 1000; ++i) {
      clock_.advance_ns(1000000);
      controller_.step();
    }
  }
  const std::vector<hal::CanFrame>& sent() const { return bus_.sent(); }

 private:
  hal::ManualClock clock_;
  hal::FakeCanBus bus_, sensor_bus_;
  firmware::CanSampleSource samples_;
  hal::FakeDrive drive_;
  hal::FakeOutput relay_, lamp_;
  hal::FakeInput stop_line_;
  hal::FakeWatchdog watchdog_;
  hal::FakeConfigurationStore store_;
  firmware::RigController controller_;
};

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  try {
    const board::BoardFile file = board::read_board_file(words[1]);
    std::ifstream text(words[2]);
    can_log::LogReader reader(text);
    const auto reference = std::make_unique<Reference>(file);
    can_log::LogEntry entry;
    while (reader.next(entry)) reference->feed(entry.frame);
    reference->stop();
    can_log::LogWriter writer(std::cout, "vcan0");
    for (const hal::CanFrame& frame : reference->sent()) writer.write(frame);
    return reader.frames() > 0 ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
